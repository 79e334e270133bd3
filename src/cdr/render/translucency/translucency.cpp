#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/render/translucency/translucency.h>

#include <algorithm>

namespace cdr::render {

namespace {

/// By Translucency.
constexpr std::array<std::string_view, kTranslucencies.size()> kNames{"weighted", "sorted"};

} // namespace

std::string_view nameOf(Translucency translucency) {
    return kNames[static_cast<std::size_t>(translucency)];
}

Translucency parseTranslucency(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) {
        throw base::InputError(base::unknownName("translucency", name, kNames));
    }
    return kTranslucencies[static_cast<std::size_t>(found - kNames.begin())];
}

} // namespace cdr::render
