#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "octahedral.glsl"

// Deferred shading by point lights. Knows view distances, not how they were mapped to depth.
layout(set = 0, binding = 0) uniform sampler2D albedoBuffer;
layout(set = 0, binding = 1) uniform usampler2D normalBuffer;
layout(set = 0, binding = 2) uniform sampler2D aheadBuffer;
layout(set = 0, binding = 3) uniform usampler2D idBuffer;
layout(set = 0, binding = 4, std430) readonly buffer Shading {
    ShadingHeader header;
    LightRecord lights[];
};

layout(location = 0) out vec4 outColor;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint id = texelFetch(idBuffer, pixel, 0).r;
    if (id == 0u) {
        outColor = vec4(header.background.rgb, 1.0);
        return;
    }
    vec4 albedo = texelFetch(albedoBuffer, pixel, 0);
    if (albedo.a == 0.0) {
        outColor = vec4(albedo.rgb, 1.0);
        return;
    }
    float ahead = texelFetch(aheadBuffer, pixel, 0).r;
    vec2 anchor = header.anchors[id >> kIdBits];
    vec2 ray = (gl_FragCoord.xy / vec2(textureSize(idBuffer, 0)) * 2.0 - 1.0) * vec2(1.0, -1.0) * header.rayScale;
    vec2 across = ray * (anchor.x + ahead);
    vec3 normal = normalize(decodeOctahedral(unpackSnorm2x16(texelFetch(normalBuffer, pixel, 0).r)));

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
    outColor = vec4(albedo.rgb * light, 1.0);
}
