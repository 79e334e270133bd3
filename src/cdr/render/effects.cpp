#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/render/effects.h>

#include <algorithm>

namespace cdr::render {

namespace {

/// By Antialias.
constexpr std::array<std::string_view, kAntialiases.size()> kNames{"none", "edges"};

} // namespace

std::string_view nameOf(Antialias antialias) {
    return kNames[static_cast<std::size_t>(antialias)];
}

Antialias parseAntialias(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) {
        throw base::InputError(base::unknownName("antialiasing", name, kNames));
    }
    return kAntialiases[static_cast<std::size_t>(found - kNames.begin())];
}

} // namespace cdr::render
