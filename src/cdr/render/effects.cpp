#include "require_length.h"

#include <cdr/base/format_error.h>
#include <cdr/render/effects.h>

#include <cmath>

namespace cdr::render {

double Fog::extinction() const {
    constexpr double kMinContrast = 0.02;
    return visibility > 0.0 ? -std::log(kMinContrast) / visibility : 0.0;
}

void requireUsable(const Effects& effects) {
    requireLength("the radius of ambient occlusion", effects.occlusion.radius);
    requireLength("the visibility in fog", effects.fog.visibility);
    if (!(std::abs(effects.finish.exposure) <= kMaxExposure)) {
        throw base::inputError("exposure must lie in -{0} to {0} stops, not {1}", kMaxExposure,
                               effects.finish.exposure);
    }
    for (int i = 0; i < 3; ++i) {
        if (!(effects.fog.color[i] >= 0.0f && effects.fog.color[i] <= 1.0f)) {
            throw base::inputError("the colour of fog must lie in 0 to 1, not {}", effects.fog.color[i]);
        }
    }
}

} // namespace cdr::render
