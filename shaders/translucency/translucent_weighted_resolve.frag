#version 460

// Lays what one cascade summed over all that is farther, by gpu::Blend::over.
layout(set = 0, binding = 0) uniform sampler2D sumImage;
layout(set = 0, binding = 1) uniform sampler2D weightImage;

layout(location = 0) out vec4 outColor;

// The largest half float. Sums beyond it are infinite, and on SwiftShader no numbers. They are taken for it, so colours are too dark.
const float kMostHalf = 65504.0;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 sum = texelFetch(sumImage, pixel, 0);
    float weight = texelFetch(weightImage, pixel, 0).r;
    if (weight == 0.0) {
        discard; // nothing, or nothing but alpha 0
    }
    // By comparisons, which are false for what is no number.
    vec3 bounded = mix(vec3(kMostHalf), sum.rgb, lessThan(sum.rgb, vec3(kMostHalf)));
    float boundedWeight = weight < kMostHalf ? weight : kMostHalf;
    outColor = vec4(bounded / boundedWeight * (1.0 - sum.a), sum.a);
}
