#include <cdr/base/number_text.h>
#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/view_constants.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace cdr::depth {

namespace {

std::optional<base::Refusal> refusalOf(const Projection& projection) {
    if (!(projection.fovY > 0.0 && projection.fovY < std::numbers::pi)) {
        return base::Refusal{base::concat(
            "the vertical field of view must lie between 0 and pi radians, not ", projection.fovY)};
    }
    if (!(projection.aspect > 0.0 && std::isfinite(projection.aspect))) {
        return base::Refusal{base::concat("width over height must be above 0, not ", projection.aspect)};
    }
    const double tangent = std::tan(0.5 * projection.fovY);
    constexpr double kMost = std::numeric_limits<float>::max();
    if (!(std::max(1.0, 1.0 / projection.aspect) / tangent <= kMost)) {
        return base::Refusal{base::concat("a field of view of ", projection.fovY,
                                          " radians and a width over height of ", projection.aspect,
                                          " are too narrow for float32")};
    }
    return {};
}

} // namespace

CascadeConstants cascadeConstants(Mapping mapping, const Cascades& cascades, std::size_t index,
                                  const Projection& projection, FarEnd farEnd) {
    return tryCascadeConstants(mapping, cascades, index, projection, farEnd).orThrow();
}

base::Result<CascadeConstants> tryCascadeConstants(Mapping mapping, const Cascades& cascades,
                                                   std::size_t index, const Projection& projection,
                                                   FarEnd farEnd) {
    if (index >= cascades.size()) {
        return base::Refusal{base::concat("there is no cascade ", index, ", only ", cascades.size())};
    }
    if (const auto refusal = refusalOf(projection)) {
        return *refusal;
    }
    const Cascade range = clipRange(mapping, cascades, index);
    const bool isLast = index + 1 == cascades.size();
    const ClipTerms terms = clipTerms(depthRange(mapping, range, isLast ? farEnd : FarEnd::closed));
    const double tangent = std::tan(0.5 * projection.fovY);
    const FloatPair anchor = floatPair(terms.anchorView);
    return CascadeConstants{.anchorView = anchor.value,
                            .scale = static_cast<float>(terms.scale),
                            .offset = static_cast<float>(terms.offset),
                            .anchorRest = anchor.rest,
                            .nearAhead = static_cast<float>(range.nearView - terms.anchorView),
                            .farAhead = static_cast<float>(range.farView - terms.anchorView),
                            .projectionX = static_cast<float>(1.0 / (projection.aspect * tangent)),
                            .projectionY = static_cast<float>(-1.0 / tangent)};
}

} // namespace cdr::depth
