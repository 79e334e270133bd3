#version 460

// Lays what one cascade summed over all that is farther, by gpu::Blend::over.
layout(set = 0, binding = 0) uniform sampler2D sumImage;
layout(set = 0, binding = 1) uniform sampler2D weightImage;

layout(location = 0) out vec4 outColor;

// The largest half float. Where sums exceed it they are infinite, and then taken for it: colours get too dark, but are numbers.
const float kMostHalf = 65504.0;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 sum = texelFetch(sumImage, pixel, 0);
    float weight = texelFetch(weightImage, pixel, 0).r;
    if (!(weight > 0.0)) {
        discard; // nothing, or nothing but alpha 0
    }
    outColor = vec4(min(sum.rgb, kMostHalf) / min(weight, kMostHalf) * (1.0 - sum.a), sum.a);
}
