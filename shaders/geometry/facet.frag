#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "geometry/depth_mapping.glsl"

// Says which facet a pixel shows, and nothing else of it. LIGHTS: says its colour under so many lights instead.
layout(constant_id = 3) const uint kWide = 0u;
layout(push_constant) uniform Push { CascadePush cascade; };

#ifdef LIGHTS
#include "geometry/facet_light.glsl"
#include "shading/finish.glsl"
layout(constant_id = 7) const uint kFinish = kFinishNone;
layout(constant_id = 8) const float kExposure = 1.0;

layout(location = kAmbientLocation) flat in vec3 inAmbient;
layout(location = kReflectedLocation) flat in vec4 inReflected[LIGHTS];
layout(location = kWayLocation) in vec3 inWay[LIGHTS];

layout(location = 0) out vec4 outColor;

// As lightOn() of shading/lighting.glsl for matt surfaces. The cosine there is a height over the facet's plane divided by a
// distance. The CPU has multiplied by the height.
vec3 litColor() {
    vec3 color = inAmbient;
    for (int i = 0; i < LIGHTS; ++i) {
        float distanceSquared = max(dot(inWay[i], inWay[i]), 1e-30);
        float reach = 1.0 + distanceSquared * inReflected[i].w;
        color += inReflected[i].rgb * (inversesqrt(distanceSquared) / reach);
    }
    return color;
}
#else
layout(location = 0) flat in uint inFacet;

layout(location = 0) out uint outFacet;
#endif
#ifdef CUTS
layout(location = 1) in float inAhead;
#endif

#ifdef WRITES_DEPTH
layout(depth_greater) out float gl_FragDepth; // than the tangent that the vertex shader set
#endif

void main() {
#ifdef CUTS
    if (kWide != 0u && isCut(clipDistances(inAhead, cascade), inAhead, gl_ClipDistance[1], cascade)) {
        discard;
    }
#endif
#ifdef LIGHTS
    outColor = vec4(finished(litColor(), kFinish, kExposure), 1.0);
#else
    outFacet = inFacet;
#endif
#ifdef WRITES_DEPTH
    gl_FragDepth = logDepthInSlice(inAhead, cascade);
#endif
}
