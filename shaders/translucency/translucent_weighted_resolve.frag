#version 460
#extension GL_GOOGLE_include_directive : require
#include "shading/brightest.glsl"

// Lays what one cascade summed over all that is farther, by gpu::Blend::over.
layout(set = 0, binding = 0) uniform sampler2D sumImage;
layout(set = 0, binding = 1) uniform sampler2D weightImage;

layout(location = 0) out vec4 outColor;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 sum = texelFetch(sumImage, pixel, 0);
    float weight = texelFetch(weightImage, pixel, 0).r;
    if (weight == 0.0) {
        discard; // nothing, or nothing but alpha 0
    }
    // Sums beyond half floats are infinite, and on SwiftShader no numbers. They are taken for the largest one, so colours are too dark.
    // By comparisons, which are false for what is no number.
    vec3 bounded = mix(vec3(kMostHalf), sum.rgb, lessThan(sum.rgb, vec3(kMostHalf)));
    float boundedWeight = weight < kMostHalf ? weight : kMostHalf;
    outColor = vec4(bounded / boundedWeight * (1.0 - sum.a), sum.a);
}
