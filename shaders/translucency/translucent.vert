#version 460
#extension GL_GOOGLE_include_directive : require
#include "translucency/translucent_shared.h"
#include "geometry/turned_normal.glsl"

layout(push_constant) uniform Push { TranslucentPush push; };

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec2 inNormal;
layout(location = 2) in vec2 inUv;
layout(location = 3) in vec4 inColor;
// Per instance: the draw's record.
layout(location = 4) in vec4 inRight;
layout(location = 5) in vec4 inUp;
layout(location = 6) in vec4 inAhead;
layout(location = 7) in vec4 inCentreRange;
layout(location = 8) in uvec4 inLook;

#ifdef DETAILED
layout(location = 9) in vec4 inTangent;
layout(location = 10) in vec2 inSecondUv;
layout(location = 6) out vec4 outTangent;
layout(location = 2) out vec4 outUv;
#else
layout(location = 2) out vec2 outUv;
#endif
layout(location = 0) out vec4 outNormalAhead;
layout(location = 1) out vec4 outColor;
layout(location = 3) flat out vec4 outCentreRange;
layout(location = 4) flat out uint outId;
layout(location = 5) flat out uint outMetallicRoughness;

// The same bits in every draw. An instance is drawn once for each cascade or slice of shadows that it is in. Each fragment
// must be in one of them.
invariant gl_Position;

void main() {
    precise float x = dot(inRight.xyz, inPosition) + inRight.w;
    precise float y = dot(inUp.xyz, inPosition) + inUp.w;
    precise float ahead = dot(inAhead.xyz, inPosition);
    precise float distanceView = inCentreRange.x + ahead;
    // No depth buffer: what is in front of what the fragment shader finds by distances alone.
    precise float acrossX = x * push.projectionX - distanceView * push.lensX;
    precise float acrossY = y * push.projectionY - distanceView * push.lensY;
    gl_Position = vec4(acrossX, acrossY, 0.0, distanceView);
    precise float inFront = distanceView - push.behind;
    gl_ClipDistance[0] = inFront;

    Axes axes = axesOf(inRight.xyz, inUp.xyz, inAhead.xyz, inLook.x);
    outNormalAhead = vec4(turnedNormal(axes, vertexNormal(inNormal)), ahead);
    outColor = inColor * vec4(unpackHalf2x16(inLook.y), unpackHalf2x16(inLook.z));
#ifdef DETAILED
    outUv = vec4(inUv, inSecondUv);
    outTangent = turnedTangent(axes, inTangent);
#else
    outUv = inUv;
#endif
    outCentreRange = inCentreRange;
    outId = inLook.x;
    outMetallicRoughness = inLook.w;
}
