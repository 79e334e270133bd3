#pragma once

#include <cdr/depth/technique.h>

#include <cstddef>
#include <string>

namespace cdr::depth {

/// What a forecast is made for: a camera, and content around one distance and something at the near plane,
/// which keeps near where it is.
struct ForecastScene {
    double nearView = 0.1;       ///< > 0
    double farView = 1e5;        ///< > nearView
    double footprintSlope = 0.0; ///< 2 tan(fovY / 2) / height
    double atView = 1e5;         ///< centre of the content, within the range
    double spanView = 32.0;      ///< depth of the content
};

/// What a technique is predicted to resolve at a distance.
struct Forecast {
    std::size_t cascades = 1;
    double bufferStepView = 0.0; ///< of the depth buffer, in the cascade that holds the distance
    double vertexStepView = 0.0; ///< what float32 arithmetic makes of a vertex before the buffer sees it
    /// Two surfaces this far apart come out in order: each may be off by the vertex rounding, and a step must
    /// fit between.
    double resolvedView() const { return bufferStepView + 2.0 * vertexStepView; }
};

/// Predicts the smallest separation a technique resolves. The vertex rounding, from DESIGN section 3:
/// - w in float32: the gap between float32 values around w;
/// - log, the logarithm taken in float32 besides: w ln(f/n) 2^-24;
/// - anchored: the gap between float32 values around the cascade's thickness.
/// base::InputError for an unusable range or a distance outside it.
Forecast forecast(const Technique& technique, const ForecastScene& scene);

/// The cascades the technique would cut.
Cascades forecastCascades(const Technique& technique, const ForecastScene& scene);

} // namespace cdr::depth
