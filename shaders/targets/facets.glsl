// A visibility buffer's facets. Define FACETS_BINDING first; set 0.
#ifndef CDR_SHADERS_FACETS_GLSL
#define CDR_SHADERS_FACETS_GLSL

#include "public/cdr_octahedral.glsl"
#include "shading/cheap_division.glsl"

layout(set = 0, binding = FACETS_BINDING) uniform usamplerBuffer facetRecords;

// @param facet what a pixel of the visibility buffer holds, not 0.
FacetRecord facetAt(uint facet) {
    int texel = 2 * (int(facet) - 1);
    uvec4 a = texelFetch(facetRecords, texel);
    uvec4 b = texelFetch(facetRecords, texel + 1);
    return FacetRecord(uintBitsToFloat(a.xy), uintBitsToFloat(a.z), a.w, uintBitsToFloat(b.x), uintBitsToFloat(b.y),
                       uintBitsToFloat(b.z), b.w);
}

// View space, unit.
vec3 normalOf(FacetRecord facet) { return unit(cdrDecodeOctahedral(facet.normal)); }

// Distance beyond the anchor plane at which a ray meets the facet's plane.
// @param normal normalOf() the facet. @param anchorView the anchor plane.
float aheadOn(FacetRecord facet, vec3 normal, vec2 ray, float anchorView) {
    // From the facet's point to the ray, in the plane of that point: small where the ray passes near it.
    vec2 across = vec2(facet.x, facet.y) - ray * (anchorView + facet.ahead);
    // Negative, since the facet faces the camera.
    float towards = min(dot(normal.xy, ray) - normal.z, -1e-20);
    return facet.ahead + clamp(dot(normal.xy, across) / towards, -facet.extent, facet.extent);
}

#endif
