#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "rivals/rivals_shared.h"
#include "geometry/depth_mapping.glsl"
#include "public/cdr_float_pair.glsl"

// Ids and distances alone. OBJECT: the distance is a pair of the draw and an offset within the object; VERTEX_PAIR: a pair
// of each vertex; else one float.
layout(constant_id = 4) const uint kDepthUse = kDepthNone;

layout(push_constant) uniform Push {
    CascadePush cascade;
    RivalPush rival;
};
#include "geometry/place.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 4) in vec4 inRight;
layout(location = 5) in vec4 inUp;
layout(location = 6) in vec4 inAhead;
layout(location = 7) in uvec2 inIdAndRest;

layout(location = 0) flat out uint outId;
#if defined(OBJECT)
layout(location = 1) out float outOffset;
layout(location = 2) flat out vec2 outCentre;
#elif defined(VERTEX_PAIR)
layout(location = 1) out vec2 outDistance;
#else
layout(location = 1) out float outAhead;
#endif

void main() {
    // The expressions of geometry.vert, so that both cover the same pixels.
    precise float x = dot(inRight.xyz, inPosition) + inRight.w;
    precise float y = dot(inUp.xyz, inPosition) + inUp.w;
    precise float offset = dot(inAhead.xyz, inPosition);
    precise float ahead = offset + inAhead.w;
    place(x, y, ahead, inAhead.w);
    if (kDepthUse == kDepthNone) {
        gl_Position.z = 0.5 * gl_Position.w; // clip distances alone cut
    } else if (kDepthUse == kDepthSieves) {
        gl_Position.z *= 1.0 + 1.0 / 16384.0; // more than float32 depth rounds
    }
    outId = inIdAndRest.x | (cascade.cascade << kIdBits);
#if defined(OBJECT)
    outOffset = offset;
    outCentre = vec2(inAhead.w, uintBitsToFloat(inIdAndRest.y));
#elif defined(VERTEX_PAIR)
    outDistance = cdrPairSum(vec2(inAhead.w, uintBitsToFloat(inIdAndRest.y)), offset);
#else
    outAhead = ahead;
#endif
}
