#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/view_constants.h>

#include <cmath>

namespace cdr::depth {

CascadeConstants cascadeConstants(Mapping mapping, const Cascades& cascades, std::size_t index,
                                  const Projection& projection, FarEnd farEnd) {
    const Cascade range = clipRange(mapping, cascades, index);
    const bool isLast = index + 1 == cascades.size();
    const ClipTerms terms = clipTerms(depthRange(mapping, range, isLast ? farEnd : FarEnd::closed));
    const double tangent = std::tan(0.5 * projection.fovY);
    const FloatPair anchor = floatPair(terms.anchorView);
    return {.anchorView = anchor.value,
            .scale = static_cast<float>(terms.scale),
            .offset = static_cast<float>(terms.offset),
            .anchorRest = anchor.rest,
            .nearAhead = static_cast<float>(range.nearView - terms.anchorView),
            .farAhead = static_cast<float>(range.farView - terms.anchorView),
            .projectionX = static_cast<float>(1.0 / (projection.aspect * tangent)),
            .projectionY = static_cast<float>(-1.0 / tangent)};
}

} // namespace cdr::depth
