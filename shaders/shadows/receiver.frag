#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/gbuffer.glsl"
#define LIGHTING_SET 0
#define LIGHTING_BINDING 1
#include "shading/lighting_buffer.glsl"
#include "shadows/shadows_shared.h"

// Which surfaces one light reaches, of those that read one of its maps: 1 or 0 in the light's channel. The least of what all
// maps say counts, so 1 is said of all else.
layout(push_constant) uniform Push { ReceiverPush push; };

layout(set = 0, binding = 0) uniform usampler2D gbuffer;
#ifdef FACETS
#define FACETS_BINDING 2
#include "targets/facets.glsl"
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

vec2 rayHere() {
    return (gl_FragCoord.xy / header.pictureSize * 2.0 - 1.0) * vec2(1.0, -1.0) * header.rayScale;
}

// What is seen at the pixel, if anything.
struct Seen {
    bool isSurface;
    Receiver receiver;
};

#ifdef FACETS
Seen seenHere(vec2 ray) {
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    Receiver receiver = Receiver(vec2(0.0), 0.0, vec3(0.0, 0.0, 1.0));
    if (texel.x != 0u) {
        FacetRecord facet = facetAt(texel.x);
        receiver.anchor = header.anchors[(facet.id >> kIdBits) & kCascadeMask];
        receiver.normal = normalOf(facet);
        receiver.ahead = aheadOn(facet, receiver.normal, ray, receiver.anchor.x);
    }
    return Seen(texel.x != 0u, receiver);
}
#else
Seen seenHere(vec2 ray) {
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    vec2 anchor = header.anchors[(texel.w >> kIdBits) & kCascadeMask];
    return Seen(texel.w != 0u, Receiver(anchor, aheadOf(texel), normalOf(texel)));
}
#endif

void main() {
    vec2 ray = rayHere();
    Seen seen = seenHere(ray);
    outReached = vec4(1.0);
    if (seen.isSurface && isOf(push, seen.receiver.anchor.x + seen.receiver.ahead)) {
        float reached = isReached(push, seen.receiver, ray) ? 1.0 : 0.0;
        for (uint i = 0u; i < 4u; ++i) {
            outReached[i] = i == push.channel ? reached : 1.0;
        }
    }
}
