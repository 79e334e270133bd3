#version 460
#extension GL_GOOGLE_include_directive : require
#include "shadows/shadows_shared.h"

// Draws what casts shadows as a light sees it.
layout(push_constant) uniform Push { CasterPush push; };

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec4 inRight;
layout(location = 2) in vec4 inUp;
layout(location = 3) in vec4 inAhead;
layout(location = 4) in float inRounding;
// MASKED: casters that a mask cuts holes into.
#ifdef MASKED
layout(location = 5) in vec2 inUv;
layout(location = 6) in vec4 inColor;
layout(location = 7) in float inLeastAlpha;
#endif

layout(location = 0) flat out float outRounding;
#ifdef MASKED
layout(location = 1) out vec3 outUvAlpha;
layout(location = 2) flat out float outLeastAlpha;
#endif

void main() {
    float right = dot(inRight.xyz, inPosition) + inRight.w;
    float up = dot(inUp.xyz, inPosition) + inUp.w;
    float ahead = dot(inAhead.xyz, inPosition) + inAhead.w;
    LightLens lens = push.lens;
    float w = lens.wOffset + lens.wPerUnit * ahead;
    // Rounded as written: the rows are sums of large numbers that nearly cancel.
    precise vec4 place = vec4(vec2(right, up) * push.scale + w * push.shift, lens.zOffset + lens.zPerUnit * ahead, w);
    gl_Position = place;
    outRounding = inRounding;
#ifdef MASKED
    outUvAlpha = vec3(inUv, inColor.a);
    outLeastAlpha = inLeastAlpha;
#endif
}
