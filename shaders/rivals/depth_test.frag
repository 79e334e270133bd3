#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "rivals/rivals_shared.h"
#include "geometry/depth_mapping.glsl"

// A fixed depth test decides: the id and the distance beyond the cascade's anchor.
layout(constant_id = 3) const uint kWide = 0u;

layout(push_constant) uniform Push {
    CascadePush cascade;
    RivalPush rival;
};

layout(location = 0) flat in uint inId;
layout(location = 1) in float inAhead;

layout(location = 0) out uvec2 outTexel;
#ifdef WRITES_DEPTH
layout(depth_greater) out float gl_FragDepth; // as in geometry.frag
#endif

void main() {
    if (kWide != 0u && isCut(clipDistances(inAhead, cascade), inAhead, gl_ClipDistance[1], cascade)) {
        discard;
    }
    outTexel = uvec2(floatBitsToUint(inAhead), inId);
#ifdef WRITES_DEPTH
    gl_FragDepth = cdrLogDepth(cascade.anchorView + inAhead, depthOf(cascade));
#endif
}
