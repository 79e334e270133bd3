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

layout(location = 0) flat out float outRounding;

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
}
