#version 460
#extension GL_GOOGLE_include_directive : require
#include "shadows/packed_slope.glsl"
#include "shadows/shadows_shared.h"

// Beside depth keeps how the surface slopes, so that a receiver can tell its own surface from what is before it.
layout(push_constant) uniform Push { CasterPush push; };

layout(location = 0) flat in float inRounding;
#ifdef MASKED
layout(location = 1) in vec3 inUvAlpha;
layout(location = 2) flat in float inLeastAlpha;
layout(set = 0, binding = 0) uniform sampler2D baseColorTexture;
#endif

layout(location = 0) out vec2 outSlope;

void main() {
    float z = gl_FragCoord.z;
    float perTexel = depthPerTexel(push.lens, z);
    vec2 slope = vec2(dFdx(z), dFdy(z)) / max(perTexel, 1e-37);
    outSlope = packedSlope(slope, inRounding * gl_FragCoord.w / push.lens.texel);
#ifdef MASKED
    if (inUvAlpha.z * texture(baseColorTexture, inUvAlpha.xy).a < inLeastAlpha) {
        discard;
    }
#endif
}
