// Clip positions for every depth mapping. View space is right-handed, looking down -z; a vertex comes in as its view-
// space x and y and as ahead = w - anchorView, its view distance beyond the anchor plane, which the CPU subtracted in
// float64 (0 for the mappings that are not anchored, so that ahead is w).
//
// Linear mappings: clip z = scale * ahead + offset, an ordinary row of a projection matrix.
//   standard  anchorView 0      scale f/(f-n)   offset -fn/(f-n)
//   reversed  anchorView 0      scale 0         offset n          (no far plane)
//   anchored  anchorView near   scale f/(f-n)   offset 0
// Logarithmic ones: clip z = w * ln(w * scale) * offset, scale 1/n, offset 1/ln(f/n).
#ifndef CDR_SHADERS_DEPTH_MAPPING_GLSL
#define CDR_SHADERS_DEPTH_MAPPING_GLSL

// Logarithmic depth of a view distance. A vertex behind the camera has no logarithm; such a draw sets its depth per
// fragment, where w is positive, and the clamp only keeps the value a number.
float logDepth(float distanceView, float scale, float offset) {
    return log(max(distanceView * scale, 1e-30)) * offset;
}

vec4 clipPosition(uint form, float x, float y, float ahead, CascadePush cascade) {
    float distanceView = cascade.anchorView + ahead;
    float z;
    if (form == kDepthFormLinear) {
        z = cascade.depthScale * ahead + cascade.depthOffset;
    } else if (form == kDepthFormLog) {
        z = logDepth(distanceView, cascade.depthScale, cascade.depthOffset) * distanceView;
    } else {
        z = 0.0; // the fragment shader sets the depth
    }
    return vec4(x * cascade.projectionX, y * cascade.projectionY, z, distanceView);
}

// Signed distances to the near and far plane of the clip range, positive inside, for gl_ClipDistance. Clip z cannot cut:
// near the far plane of a ratio-1000 cascade z - w changes by a thousandth of what w does, so float32 clipping at z = w
// would be off by a ten-thousandth of the distance. Pipelines clamp depth, so that clip z does not cut.
vec2 clipDistances(float ahead, CascadePush cascade) {
    return vec2(ahead - cascade.nearAhead, cascade.farAhead - ahead);
}

#endif
