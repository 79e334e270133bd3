#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/depth/rounding.h>
#include <cdr/depth/technique.h>

#include <cstddef>
#include <optional>

namespace cdr::depth {

/// What a forecast is for: a camera and content around one distance. By default there is also something at
/// the near plane. It keeps the near plane where it is, and takes a fitted cascade of its own.
struct ForecastScene {
    double nearView = 0.1;       ///< > 0
    double farView = 1e5;        ///< > nearView
    double footprintSlope = 0.0; ///< 2 tan(fovY / 2) / height; > 0 and finite with subPixelBits
    double atView = 1e5;         ///< centre of the content, within the range
    double spanView = 32.0;      ///< depth of the content
    bool somethingNear = true;   ///< whether something is at the near plane
    /// Bits that the device snaps vertices to, at most 32. Empty: it does not, or the surfaces to tell apart share
    /// their outline, so that snapping moves them alike.
    std::optional<unsigned> subPixelBits{};
    double slope = 1.0; ///< of these surfaces, as snapGapView() has it; finite, at least 0
};

/// What a technique is predicted to resolve at a distance.
struct CDR_EXPORT Forecast {
    std::size_t cascades = 1;    ///< that the technique takes
    double bufferStepView = 0.0; ///< of the depth buffer, in the cascade that holds the distance
    DepthRounding rounding;      ///< of one surface, before the buffer sees it

    /// Surfaces this far apart come out in order except for single pixels. It is a step of the buffer, and two
    /// standard deviations of the rounding of two surfaces by float32 and snapping.
    double resolvedView() const;
    /// Surfaces this far apart come out in order everywhere. It is a step of the buffer, and every rounding of
    /// both surfaces at its worst.
    double guaranteedView() const { return bufferStepView + 2.0 * rounding.worstView(); }
};

/// Predicts the smallest separation a technique resolves.
/// @throws base::InputError for an unusable range, a distance outside it, snapping out of its ranges, or a split fitted
///         to pixels without footprintSlope.
CDR_EXPORT Forecast forecast(const Technique& technique, const ForecastScene& scene);
/// forecast(), refused instead of thrown.
CDR_EXPORT base::Result<Forecast> tryForecast(const Technique& technique, const ForecastScene& scene);

/// The same in cascades that were cut, such as a frame's. Nothing where none of them holds the distance, with a little
/// room about each, since what is drawn overlaps.
CDR_EXPORT std::optional<Forecast> forecastIn(const Technique& technique, const Cascades& cascades,
                                              double distanceView);

/// The cascades the technique would cut.
/// @throws base::InputError as forecast().
CDR_EXPORT Cascades forecastCascades(const Technique& technique, const ForecastScene& scene);
/// forecastCascades(), refused instead of thrown.
CDR_EXPORT base::Result<Cascades> tryForecastCascades(const Technique& technique, const ForecastScene& scene);

} // namespace cdr::depth
