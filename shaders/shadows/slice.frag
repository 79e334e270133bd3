#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/gbuffer.glsl"
#include "shadows/seen.glsl"
#include "shadows/shadows_shared.h"

// Writes which slice a pixel's surface is in as its depth, so that a depth test finds the pixels of a slice. Background: 0.
layout(push_constant) uniform Push { SlicePush push; };

// From 1 on. The same float decides as ReceiverPush::nearView and farView.
uint sliceOf(float distanceView) {
    if (push.isPlain != 0u) {
        bvec4 isBeyond = lessThanEqual(push.nearView, vec4(distanceView));
        return uint(isBeyond.x) + uint(isBeyond.y) + uint(isBeyond.z) + uint(isBeyond.w);
    }
    return floatBitsToUint(distanceView) >> 23; // its exponent, and 0 as its sign
}

void main() {
    Seen seen = seenHere(rayHere());
    gl_FragDepth = seen.isSurface ? float(sliceOf(distanceOf(seen.receiver))) / kMaxSlices : 0.0;
}
