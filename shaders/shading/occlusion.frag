#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/gbuffer.glsl"
#include "shading/lighting.glsl"
#include "shading/flat_anchors.glsl"

// Ambient occlusion over the whole picture, whichever cascades its surfaces come from.
layout(set = 0, binding = 0) uniform usampler2D gbuffer;

layout(location = 0) out float outOcclusion;

vec2 anchorOf(uvec4 texel) { return anchorOf((texel.w >> kIdBits) & kCascadeMask); }
float distanceOf(uvec4 texel) { return anchorOf(texel).x + aheadOf(texel); }
float aheadBetween(uvec4 from, uvec4 to) { return distanceBetween(anchorOf(from), aheadOf(from), anchorOf(to), aheadOf(to)); }
#include "shading/occlusion.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec4 texel = texelFetch(gbuffer, pixel, 0);
    outOcclusion = texel.w == 0u ? 0.0
                                   : occlusionAt(gbuffer, pixel, texel, flatRays.xy, flatRays.zw, flatPicture.z);
}
