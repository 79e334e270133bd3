#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/render/submit/draw_path.h>

#include <fmt/format.h>

#include <algorithm>

namespace cdr::render {

namespace {

/// By Submission.
constexpr std::array<std::string_view, kSubmissions.size()> kNames{"secondaries", "primaries", "gpu-driven"};

} // namespace

std::string_view nameOf(Submission submission) {
    return kNames[static_cast<std::size_t>(submission)];
}

std::string labelOf(base::IndexRange cascades) {
    return cascades.size() == 1 ? fmt::format("cascade {}", cascades.begin)
                                : fmt::format("cascades {} to {}", cascades.begin, cascades.end - 1);
}

Submission parseSubmission(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) {
        throw base::InputError(base::unknownName("submission", name, kNames));
    }
    return kSubmissions[static_cast<std::size_t>(found - kNames.begin())];
}

} // namespace cdr::render
