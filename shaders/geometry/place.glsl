// Where a vertex lies and what cuts its triangle, for all vertex shaders of the geometry pass. Declare the push
// constants with a CascadePush named `cascade` first.
#ifndef CDR_SHADERS_PLACE_GLSL
#define CDR_SHADERS_PLACE_GLSL

layout(constant_id = 0) const uint kDepthForm = kDepthFormLinear;
layout(constant_id = 3) const uint kWide = 0u;
layout(constant_id = 5) const float kSnapStepsX = 0.0; // of vertices, from the picture's middle to its edge; 0: none
layout(constant_id = 6) const float kSnapStepsY = 0.0;

// The same bits from every pipeline: cascades, wide draws and batchings promise one picture.
invariant gl_Position;

// @param centreAhead of the draw's origin, or of anything that is not farther.
void place(float x, float y, float ahead, float centreAhead) {
    gl_Position = clipPosition(kDepthForm, x, y, ahead, centreAhead, cascade);
    if (kSnapStepsX != 0.0 && gl_Position.w > 0.0) {
        vec2 steps = vec2(kSnapStepsX, kSnapStepsY);
        gl_Position.xy = round(gl_Position.xy / gl_Position.w * steps) / steps * gl_Position.w;
    }
    vec2 inside = clipDistances(ahead, cascade);
    if (kWide != 0u) {
        // The fragment shader cuts wide draws; here only what lies behind the camera must go.
        inside.x = cdrInFront(gl_Position.w, cascade.anchorView + cascade.nearAhead).x;
        inside.y = cdrRounding(vec2(x, y), ahead, centreAhead, cascade.anchorView); // for isCut(); above 0, so it cuts nothing
    }
    gl_ClipDistance[0] = inside.x;
    gl_ClipDistance[1] = inside.y;
}

#endif
