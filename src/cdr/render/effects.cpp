#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/render/effects.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cdr::render {

namespace {

/// By Antialias.
constexpr std::array<std::string_view, kAntialiases.size()> kNames{"none", "edges"};

void requireLength(const char* what, double length) {
    if (!std::isfinite(length) || length < 0.0) {
        throw base::InputError(fmt::format("{} must be finite and not negative, not {}", what, length));
    }
}

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

double Fog::extinction() const {
    constexpr double kLeastContrast = 0.02;
    return visibility > 0.0 ? -std::log(kLeastContrast) / visibility : 0.0;
}

void requireUsable(const Effects& effects) {
    requireLength("the radius of ambient occlusion", effects.occlusion.radius);
    requireLength("the visibility in fog", effects.fog.visibility);
    for (int i = 0; i < 3; ++i) {
        if (!(effects.fog.color[i] >= 0.0f && effects.fog.color[i] <= 1.0f)) {
            throw base::InputError(
                fmt::format("the colour of fog must lie in 0 to 1, not {}", effects.fog.color[i]));
        }
    }
}

} // namespace cdr::render
