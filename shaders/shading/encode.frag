#version 460
#extension GL_GOOGLE_include_directive : require

// The linear lit image as the picture; its sRGB format encodes.
layout(set = 0, binding = 0) uniform sampler2D litImage;

#include "shading/finish.glsl"
layout(constant_id = 0) const uint kFinish = kFinishNone;
layout(constant_id = 1) const float kExposure = 1.0;

layout(location = 0) out vec4 outColor;

vec3 litAt(ivec2 pixel) {
    ivec2 last = textureSize(litImage, 0) - 1;
    return clamp(finished(texelFetch(litImage, clamp(pixel, ivec2(0), last), 0).rgb, kFinish, kExposure), 0.0, 1.0);
}

#ifdef ANTIALIASED
#include "shading/edge_antialias.glsl"
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef ANTIALIASED
    outColor = vec4(smoothEdges(pixel), 1.0);
#else
    outColor = vec4(litAt(pixel), 1.0);
#endif
}
