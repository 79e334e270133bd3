#include <cdr/base/enum_names.h>
#include <cdr/render/submit/draw_path.h>

#include <fmt/format.h>

namespace cdr::render {

namespace {

constexpr base::EnumNames<Submission, kSubmissions.size()> kNames{"submission",
                                                                  {"secondaries", "primaries", "gpu-driven"}};

} // namespace

std::string_view nameOf(Submission submission) {
    return kNames.nameOf(submission);
}

std::string labelOf(std::span<const std::size_t> cascades) {
    return cascades.size() == 1 ? fmt::format("cascade {}", cascades.front())
                                : fmt::format("cascades {} to {}", cascades.front(), cascades.back());
}

Submission parseSubmission(std::string_view name) {
    return kNames.parse(name);
}

} // namespace cdr::render
