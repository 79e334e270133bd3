#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/gbuffer.glsl"
#include "shadows/seen.glsl"
#include "shadows/shadows_shared.h"

// Which surfaces one light reaches, of those that read one of its maps: 1 or 0 in the light's channel. The least of what all
// maps say counts, so 1 is said of all else. The depth test lets only pixels of the map's slice come here (slice.frag).
layout(push_constant) uniform Push { ReceiverPush push; };

#define MAP_SET 0
#ifdef FACETS
#define MAP_BINDING 3
#else
#define MAP_BINDING 2
#endif
#include "shadows/reached.glsl"

layout(location = 0) out vec4 outReached;

void main() {
    vec2 ray = rayHere();
    float reached = isReached(push, seenHere(ray).receiver, ray) ? 1.0 : 0.0;
    for (uint i = 0u; i < kShadowChannels; ++i) {
        outReached[i] = i == push.channel ? reached : 1.0;
    }
}
