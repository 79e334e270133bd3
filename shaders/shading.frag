#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "surface.glsl"
#define LIGHTING_SET 0
#define LIGHTING_BINDING 1
#include "lighting.glsl"

// Deferred shading of the final G-buffer.
layout(set = 0, binding = 0) uniform usampler2D surfaceBuffer;

layout(location = 0) out vec4 outColor;

void main() {
    uvec4 surface = texelFetch(surfaceBuffer, ivec2(gl_FragCoord.xy), 0);
    if (surface.w == 0u) {
        outColor = vec4(header.background.rgb, 1.0);
        return;
    }
    vec3 albedo = albedoOf(surface);
    if ((surface.w & kIdUnlit) != 0u) {
        outColor = vec4(albedo, 1.0);
        return;
    }
    float ahead = aheadOf(surface);
    vec2 anchor = header.anchors[(surface.w >> kIdBits) & kCascadeMask];
    vec2 across = rayAt(gl_FragCoord.xy, vec2(textureSize(surfaceBuffer, 0))) * (anchor.x + ahead);
    outColor = vec4(albedo * lightOn(normalOf(surface), across, anchor, ahead), 1.0);
}
