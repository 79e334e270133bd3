#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/base/result.h>
#include <cdr/depth/mapping.h>

#include <cstddef>

namespace cdr::depth {

/// A perspective lens, as a projection matrix has it. The matrix must be finite in float32.
struct Projection {
    double fovY = 0.0;   ///< vertical field of view in radians, above 0 and below pi
    double aspect = 1.0; ///< width / height, above 0 and finite
};

/// What a vertex shader needs of one cascade: CdrCascade of shaders/public/cdr_depth.glsl. Its two vec4 have the same
/// 32 bytes as push constants, in a uniform buffer and in a storage buffer.
struct CascadeConstants {
    float anchorView = 0.0f;  ///< ClipTerms
    float scale = 0.0f;       ///< ClipTerms
    float offset = 0.0f;      ///< ClipTerms
    float anchorRest = 0.0f;  ///< what `anchorView` leaves out of the float64 anchor, for cdr_view.glsl
    float nearAhead = 0.0f;   ///< clipRange() less anchorView, subtracted in float64
    float farAhead = 0.0f;    ///< the same of the far end
    float projectionX = 0.0f; ///< 1 / (aspect tan(fovY / 2))
    float projectionY = 0.0f; ///< -1 / tan(fovY / 2): y points down in Vulkan
};
static_assert(sizeof(CascadeConstants) == 32);
static_assert(offsetof(CascadeConstants, nearAhead) == 16);

/// The constants of cascade `index` of makeCascades().
/// @throws base::InputError for an index that is no cascade's, and for a projection outside the limits above.
/// @param farEnd as depthRange() takes it.
CDR_EXPORT CascadeConstants cascadeConstants(Mapping mapping, const Cascades& cascades, std::size_t index,
                                             const Projection& projection, FarEnd farEnd = FarEnd::open);
/// The same, refused instead of thrown.
CDR_EXPORT base::Result<CascadeConstants> tryCascadeConstants(Mapping mapping, const Cascades& cascades,
                                                              std::size_t index, const Projection& projection,
                                                              FarEnd farEnd = FarEnd::open);

} // namespace cdr::depth
