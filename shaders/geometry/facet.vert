#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "geometry/depth_mapping.glsl"

// Corners that the CPU has transformed (FacetVertex), for a visibility buffer. CUTS: fragments are cut, or given their
// depth, by their own distance. DEPTH_ALONE: nobody asks which facet it is.
layout(push_constant) uniform Push { CascadePush cascade; };
#include "geometry/place.glsl"

layout(location = 0) in vec3 inPlace; // view-space x and y, and the distance beyond the anchor
#ifndef DEPTH_ALONE
layout(location = 1) in uint inFacet;

layout(location = 0) flat out uint outFacet;
#endif
#ifdef CUTS
layout(location = 1) out float outAhead;
#endif

void main() {
    // The nearest distance that the cascade draws is never above a draw's own.
    place(inPlace.x, inPlace.y, inPlace.z, cascade.nearAhead);
#ifndef DEPTH_ALONE
    outFacet = inFacet;
#endif
#ifdef CUTS
    outAhead = inPlace.z;
#endif
}
