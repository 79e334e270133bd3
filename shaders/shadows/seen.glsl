// What is seen at a pixel, by the G-buffer or, with FACETS, by a visibility buffer and its facets. Include "shared.h" and
// "targets/gbuffer.glsl" first.
#ifndef CDR_SHADERS_SEEN_GLSL
#define CDR_SHADERS_SEEN_GLSL

#include "shading/lighting_buffer.glsl"
#include "shading/flat_anchors.glsl"
#include "shadows/receiver.glsl"

layout(set = 0, binding = 0) uniform usampler2D gbuffer;
#ifdef FACETS
#define FACETS_BINDING 2
#include "targets/facets.glsl"
#endif

vec2 rayHere() {
    return (gl_FragCoord.xy / flatPicture.xy * 2.0 - 1.0) * vec2(1.0, -1.0) * flatRays.xy + flatRays.zw;
}

struct Seen {
    bool isSurface;
    Receiver receiver; // if it is one
};

#ifdef FACETS
Seen seenHere(vec2 ray) {
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    Receiver receiver = Receiver(vec2(0.0), 0.0, vec3(0.0, 0.0, 1.0));
    if (texel.x != 0u) {
        FacetRecord facet = facetAt(texel.x);
        receiver.anchor = anchorOf((facet.id >> kIdBits) & kCascadeMask);
        receiver.normal = normalOf(facet);
        receiver.ahead = aheadOn(facet, receiver.normal, ray, receiver.anchor.x);
    }
    return Seen(texel.x != 0u, receiver);
}
#else
Seen seenHere(vec2 ray) {
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    vec2 anchor = anchorOf((texel.w >> kIdBits) & kCascadeMask);
    return Seen(texel.w != 0u, Receiver(anchor, aheadOf(texel), normalOf(texel)));
}
#endif

#endif
