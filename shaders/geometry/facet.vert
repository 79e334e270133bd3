#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "geometry/depth_mapping.glsl"

// Corners that the CPU has transformed (FacetVertex), for a visibility buffer. CUTS: fragments are cut, or given their
// depth, by their own distance. DEPTH_ALONE: nobody asks which facet it is. LIGHTS: they are lit by so many while
// they are drawn.
#ifdef LIGHTS
#include "geometry/facet_light.glsl"
layout(push_constant) uniform Push {
    CascadePush cascade;
    layout(offset = kPushedLightsOffset) vec4 lights[LIGHTS];
};
#else
layout(push_constant) uniform Push { CascadePush cascade; };
#endif
#include "geometry/place.glsl"

layout(location = 0) in vec3 inPlace; // view-space x and y, and the distance beyond the anchor
#if defined(LIGHTS)
layout(location = 1) in vec3 inAmbient;
layout(location = 2) in vec3 inReflected[LIGHTS];

layout(location = kAmbientLocation) flat out vec3 outAmbient;
layout(location = kReflectedLocation) flat out vec4 outReflected[LIGHTS];
layout(location = kWayLocation) out vec3 outWay[LIGHTS];
#elif !defined(DEPTH_ALONE)
layout(location = 1) in uint inFacet;

layout(location = 0) flat out uint outFacet;
#endif
#ifdef CUTS
layout(location = 1) out float outAhead;
#endif

void main() {
    // The nearest distance that the cascade draws is never above a draw's own.
    place(inPlace.x, inPlace.y, inPlace.z, cascade.nearAhead);
#if defined(LIGHTS)
    outAmbient = inAmbient;
    for (int i = 0; i < LIGHTS; ++i) {
        outReflected[i] = vec4(inReflected[i], lights[i].w);
        outWay[i] = lights[i].xyz - inPlace;
    }
#elif !defined(DEPTH_ALONE)
    outFacet = inFacet;
#endif
#ifdef CUTS
    outAhead = inPlace.z;
#endif
}
