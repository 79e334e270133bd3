#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "public/cdr_gbuffer.glsl"
#include "shading/lighting_buffer.glsl"

// Writes the depth that a host's own camera has of what the G-buffer shows: a linear mapping of its view distance.
layout(set = 0, binding = 0) uniform usampler2D gbuffer;
layout(push_constant) uniform Push { HostDepthPush terms; };

void main() {
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    vec2 distanceView = cdrDistanceViewOf(texel, header.anchors[cdrCascadeOf(texel)]);
    gl_FragDepth = cdrIdOf(texel) == 0u ? terms.background : terms.scale + terms.offset / distanceView.x;
}
