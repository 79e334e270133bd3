#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "surface.glsl"

// Deferred shading by point lights. Knows view distances, not how they were mapped to depth.
layout(set = 0, binding = 0) uniform usampler2D surfaceBuffer;
layout(set = 0, binding = 1, std430) readonly buffer Shading {
    ShadingHeader header;
    LightRecord lights[];
};

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
    vec3 normal = normalOf(surface);
    vec2 anchor = header.anchors[(surface.w >> kIdBits) & kCascadeMask];
    vec2 ray = (gl_FragCoord.xy / vec2(textureSize(surfaceBuffer, 0)) * 2.0 - 1.0) * vec2(1.0, -1.0) * header.rayScale;
    vec2 across = ray * (anchor.x + ahead);

    vec3 light = header.ambient.rgb;
    for (uint i = 0u; i < header.lightCount; ++i) {
        LightRecord record = lights[i];
        // Subtracting float from float and rest from rest keeps the small difference of two large distances.
        float lightAhead = (record.position.z - anchor.x) + (record.positionRest.z - anchor.y);
        vec2 lightAcross = (record.position.xy - across) + record.positionRest.xy;
        vec3 toLight = vec3(lightAcross, ahead - lightAhead);
        float distanceSquared = dot(toLight, toLight);
        float lambert = max(dot(normal, toLight) * inversesqrt(max(distanceSquared, 1e-30)), 0.0);
        float half2 = record.position.w * record.position.w;
        light += record.color.rgb * (lambert * half2 / (half2 + distanceSquared));
    }
    outColor = vec4(albedo * light, 1.0);
}
