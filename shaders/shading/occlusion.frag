#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/surface.glsl"
#define LIGHTING_SET 0
#define LIGHTING_BINDING 1
#include "shading/lighting.glsl"

// Ambient occlusion over the whole picture, whichever cascades its surfaces come from.
layout(set = 0, binding = 0) uniform usampler2D surfaceBuffer;

layout(location = 0) out float outOcclusion;

vec2 anchorOf(uvec4 surface) { return header.anchors[(surface.w >> kIdBits) & kCascadeMask]; }
float distanceOf(uvec4 surface) { return anchorOf(surface).x + aheadOf(surface); }
float aheadBetween(uvec4 from, uvec4 to) { return distanceBetween(anchorOf(from), aheadOf(from), anchorOf(to), aheadOf(to)); }
#include "shading/occlusion.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec4 surface = texelFetch(surfaceBuffer, pixel, 0);
    outOcclusion = surface.w == 0u ? 0.0
                                   : occlusionAt(surfaceBuffer, pixel, surface, header.rayScale, header.occlusionRadius);
}
