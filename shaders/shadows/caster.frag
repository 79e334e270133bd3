#version 460
#extension GL_GOOGLE_include_directive : require
#include "shadows/shadows_shared.h"

// Beside depth keeps how the surface slopes, so that a receiver can tell its own surface from what is before it.
layout(push_constant) uniform Push { CasterPush push; };

#ifdef MASKED
layout(location = 0) in vec3 inUvAlpha;
layout(location = 1) flat in float inLeastAlpha;
layout(set = 0, binding = 0) uniform sampler2D baseColorTexture;
#endif

// Texels towards the light per texel across and down.
layout(location = 0) out vec2 outSlope;

const float kMaxSlope = 1000.0;

void main() {
    float z = gl_FragCoord.z;
    float perTexel = depthPerTexel(push.lens, z);
    vec2 slope = vec2(dFdx(z), dFdy(z)) / max(perTexel, 1e-37);
    outSlope = clamp(slope, -kMaxSlope, kMaxSlope);
#ifdef MASKED
    if (inUvAlpha.z * texture(baseColorTexture, inUvAlpha.xy).a < inLeastAlpha) {
        discard;
    }
#endif
}
