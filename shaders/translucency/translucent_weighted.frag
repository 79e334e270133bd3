#version 460
#extension GL_GOOGLE_include_directive : require
#define DETAIL_SET 2
#include "translucency/translucent_fragment.glsl"

// Weighted, blended, order-independent: McGuire and Bavoil 2013, equations 5 and 10. Their depth is here the place
// in the cascade's range on a logarithmic scale.
layout(location = 0) out vec4 outSum;    // colours, and in alpha the transmittance, by gpu::Blend::accumulate
layout(location = 1) out vec4 outWeight; // red
layout(location = 2) out vec4 outCount; // red, where fragments are counted

void main() {
    TranslucentFragment fragment = translucentFragment();
    float place = clamp(log(max(fragment.distanceView.x / push.nearView, 1e-30)) * push.spread, 0.0, 1.0);
    float nearness = 1.0 - place;
    // The near end of equation 10, 3e3, over 50. So half floats hold sums of 1091 of the nearest, opaque layers, and sums of their
    // colours while these are 1 or less; of kBrightest, 68. The resolve bounds what is more. The far end as it is: what is added
    // is this times alpha squared, which half floats hold from alpha 1/255 on.
    float weight = fragment.color.a * max(1e-2, 60.0 * nearness * nearness * nearness);
    outSum = vec4(fragment.color.rgb * fragment.color.a * weight, fragment.color.a);
    outWeight = vec4(fragment.color.a * weight, 0.0, 0.0, 0.0);
    outCount = vec4(1.0, 0.0, 0.0, 0.0);
}
