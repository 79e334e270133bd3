#include <viewer/state/requests/open_progress.h>

#include <fmt/format.h>

#include <filesystem>

namespace cdr::viewer {

std::string textOf(const OpenProgress& progress) {
    const double percent = 100.0 * static_cast<double>(progress.done) / static_cast<double>(progress.all);
    return fmt::format("opening {}: {:.0f} %", std::filesystem::path(progress.file).filename().string(),
                       percent);
}

} // namespace cdr::viewer
