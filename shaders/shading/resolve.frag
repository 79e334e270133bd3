#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/gbuffer.glsl"
#include "shading/lighting.glsl"
#define FACETS_BINDING 2
#include "targets/facets.glsl"

// Writes the G-buffer that a visibility buffer stands for.
layout(set = 0, binding = 0) uniform usampler2D visibility;

layout(location = 0) out uvec4 outTexel;

void main() {
    uint facet = texelFetch(visibility, ivec2(gl_FragCoord.xy), 0).x;
    outTexel = uvec4(0u);
    if (facet != 0u) {
        FacetRecord record = facetAt(facet);
        vec3 normal = normalOf(record);
        vec2 ray = rayAt(gl_FragCoord.xy, vec2(textureSize(visibility, 0)));
        float anchorView = header.anchors[(record.id >> kIdBits) & kCascadeMask].x;
        outTexel = uvec4(record.albedo, encodeNormal(normal), floatBitsToUint(aheadOn(record, normal, ray, anchorView)),
                         record.id);
    }
}
