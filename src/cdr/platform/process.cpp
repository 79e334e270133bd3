#include <cdr/platform/process.h>

#include <unistd.h>

#include <system_error>
#include <utility>

namespace cdr::platform {

long processId() {
    return static_cast<long>(::getpid());
}

std::optional<std::filesystem::path> ownProgram() {
    std::error_code error;
    std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::nullopt : std::optional(std::move(program));
}

} // namespace cdr::platform
