#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "geometry/depth_mapping.glsl"

// Says which facet a pixel shows, and nothing else of it.
layout(constant_id = 3) const uint kWide = 0u;
layout(push_constant) uniform Push { CascadePush cascade; };

layout(location = 0) flat in uint inFacet;
#ifdef CUTS
layout(location = 1) in float inAhead;
#endif

layout(location = 0) out uint outFacet;
#ifdef WRITES_DEPTH
layout(depth_greater) out float gl_FragDepth; // than the tangent that the vertex shader set
#endif

void main() {
#ifdef CUTS
    if (kWide != 0u && cdrIsOutside(clipDistances(inAhead, cascade))) {
        discard;
    }
#endif
    outFacet = inFacet;
#ifdef WRITES_DEPTH
    // The viewport moves interpolated depths into the slice, but not those set here.
    float depth = cdrLogDepth(cascade.anchorView + inAhead, depthOf(cascade));
    gl_FragDepth = cascade.minDepth + depth * (cascade.maxDepth - cascade.minDepth);
#endif
}
