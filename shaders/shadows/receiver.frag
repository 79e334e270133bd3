#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/gbuffer.glsl"
#include "shadows/seen.glsl"
#include "shadows/shadows_shared.h"

// Which surfaces one light reaches, of those that read one of its maps: 1 or 0 in the light's channel. The least of what all
// maps say counts, so 1 is said of all else. The depth test lets only pixels of the map's slice come here (slice.frag).
layout(push_constant) uniform Push { ReceiverPush push; };

#ifdef FACETS
layout(set = 0, binding = 3) uniform sampler2D mapDepth;
layout(set = 0, binding = 4) uniform sampler2D mapSlope;
#else
layout(set = 0, binding = 2) uniform sampler2D mapDepth;
layout(set = 0, binding = 3) uniform sampler2D mapSlope;
#endif

layout(location = 0) out vec4 outReached;

float mapDepthAt(ivec2 texel) { return texelFetch(mapDepth, texel, 0).r; }
vec3 mapSlopeAt(ivec2 texel) { return texelFetch(mapSlope, texel, 0).xyz; }
#include "shadows/reached.glsl"

void main() {
    vec2 ray = rayHere();
    float reached = isReached(push, seenHere(ray).receiver, ray) ? 1.0 : 0.0;
    for (uint i = 0u; i < 4u; ++i) {
        outReached[i] = i == push.channel ? reached : 1.0;
    }
}
