// The depth mappings of cdr_depth.glsl over this renderer's push constants.
#ifndef CDR_SHADERS_DEPTH_MAPPING_GLSL
#define CDR_SHADERS_DEPTH_MAPPING_GLSL

#include "public/cdr_depth.glsl"

CdrDepth depthOf(CascadePush cascade) {
    return CdrDepth(cascade.anchorView, cascade.depthScale, cascade.depthOffset);
}

// Clip x and y.
vec2 projectedOf(float x, float y, float ahead, CascadePush cascade) {
    precise vec2 projected = vec2(x * cascade.projectionX, y * cascade.projectionY) -
                             (cascade.anchorView + ahead) * vec2(cascade.lensX, cascade.lensY);
    return projected;
}

// For gl_FragDepth. The viewport moves interpolated depths into the slice, but not those that a shader sets.
float logDepthInSlice(float ahead, CascadePush cascade) {
    float depth = cdrLogDepth(cascade.anchorView + ahead, depthOf(cascade));
    return cascade.minDepth + depth * (cascade.maxDepth - cascade.minDepth);
}

// centreAhead: of the draw's origin.
vec4 clipPosition(uint form, float x, float y, float ahead, float centreAhead, CascadePush cascade) {
    vec2 projected = projectedOf(x, y, ahead, cascade);
    if (form == kDepthFormLinear) {
        return cdrClipPosition(projected, ahead, depthOf(cascade));
    }
    if (form == kDepthFormLog) {
        return cdrClipPositionLog(projected, ahead, depthOf(cascade));
    }
    float touchView = cascade.anchorView + clamp(centreAhead, cascade.nearAhead, cascade.farAhead);
    return cdrClipPositionLogTangent(projected, ahead, touchView, depthOf(cascade));
}

// Signed distances to the near and far plane of the clip range, positive inside, for gl_ClipDistance. Clip z cannot cut.
// Near the far plane of a ratio-1000 cascade z - w changes by a thousandth of what w does. So float32 clipping at z = w
// would be off by a ten-thousandth of the distance. Pipelines clamp depth, so that clip z does not cut.
vec2 clipDistances(float ahead, CascadePush cascade) {
    return cdrInside(ahead, vec2(cascade.nearAhead, cascade.farAhead));
}

// Whether a fragment of a wide draw belongs to other cascades.
// inside: clipDistances() of its own distance. rounding: cdrRounding(), as place() hands it over.
bool isCut(vec2 inside, float ahead, float rounding, CascadePush cascade) {
    if (cascade.cascade != 0u) {
        inside = cdrInsideWide(inside, rounding, cascade.anchorView + ahead);
    }
    return cdrIsOutside(inside);
}

#endif
