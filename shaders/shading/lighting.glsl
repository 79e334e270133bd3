// Ambient and point lights on a surface, for the deferred pass and for what is drawn after it. Define SKY_CONSTANT where
// the scene may have a sky, AIR_CONSTANT where it may have air, and SHADOWED where points know which lights reach them.
// Knows view distances, not how they were mapped to depth. Where the lights are bound says lighting_buffer.glsl.
// FLAT_LIGHTING: what all pixels share comes as flat varyings from shading.vert (flat_lighting.glsl), not from the buffer.
#ifndef CDR_SHADERS_LIGHTING_GLSL
#define CDR_SHADERS_LIGHTING_GLSL

#include "shading/lighting_buffer.glsl"
#include "shading/metallic_roughness.glsl"
#include "shading/sky.glsl"

// Whether light from all around is that of a sky; else it is alike from everywhere.
#ifdef SKY_CONSTANT
layout(constant_id = SKY_CONSTANT) const uint kSky = 0u;
#else
const uint kSky = 0u;
#endif

#ifdef FLAT_LIGHTING
#include "shading/flat_lighting.glsl"
#else
vec3 ambientLight() { return header.ambient; }
vec3 fogColor() { return header.fog.rgb; }
float fogExtinction() { return header.fog.a; }
vec3 backgroundColor() { return header.background; }
vec2 rayScale() { return header.rayScale; }
float occlusionRadius() { return header.occlusionRadius; }
uint lightCount() { return header.lightCount; }
LightRecord lightAt(uint i) { return lights[i]; }
bool isShaped(LightRecord light) { return light.color.w != 0.0; }
#endif

// View-space x and y per unit of view distance at a pixel.
#ifdef FLAT_LIGHTING
vec2 rayAt(vec2 pixel) { return pixel * flatRay.xy + flatRay.zw; }
#else
vec2 rayAt(vec2 pixel, vec2 pictureSize) {
    return (pixel / pictureSize * 2.0 - 1.0) * vec2(1.0, -1.0) * rayScale() + header.rayCentre;
}
#endif

// Difference of two view distances, each an anchor plane (a float and its rest) and what lies ahead of it.
float distanceBetween(vec2 fromAnchor, float fromAhead, vec2 toAnchor, float toAhead) {
    precise float between = (toAnchor.x - fromAnchor.x) + (toAnchor.y - fromAnchor.y) + (toAhead - fromAhead);
    return between;
}

// What a colour becomes through the fog between the camera and a point on a ray.
vec3 throughFog(vec3 color, vec2 ray, float distanceView) {
    float distance = distanceView * length(vec3(ray, 1.0));
    return mix(fogColor(), color, exp(-fogExtinction() * distance));
}

#ifdef AIR_CONSTANT
layout(constant_id = AIR_CONSTANT) const uint kAiry = 0u;
#include "shading/air.glsl"

// What a colour becomes through the air between the camera and a point on a ray; below 0: and nothing behind.
vec3 throughAir(vec3 color, vec2 ray, float distanceView) {
    vec3 way = vec3(ray, -1.0);
    float perView = length(way);
    AirSeen seen = airAlong(header.air, way / perView, distanceView * perView);
    return color * seen.passed + seen.added;
}
#endif

// A point that is lit, in view space.
struct LitPoint {
    vec3 normal;
    vec2 ray;    // x and y per unit of view distance
    vec2 anchor; // view distance: that of a plane, a float and its rest,
    float ahead; // and what lies beyond
    float openness; // the share of ambient light that reaches it
#ifdef SHADOWED
    vec4 reached; // the shares of the first lights that reach it
#endif
};

// From a point to a light. Subtracting float from float and rest from rest keeps the small difference of two large
// distances; none of it is fused with a multiplication.
vec3 wayTo(LightRecord light, LitPoint point) {
    vec2 across = point.ray * (point.anchor.x + point.ahead);
    float lightAhead = (light.position.z - point.anchor.x) + (light.positionRest.z - point.anchor.y);
    precise vec2 lightAcross = (light.position.xy - across) + light.positionRest.xy;
    precise float ahead = point.ahead - lightAhead;
    return vec3(lightAcross, ahead);
}

// The share of light i that no shadow takes, and that its range and its cone let through (KHR_lights_punctual).
float shareOf(uint i, LightRecord light, LitPoint point, vec3 way, float distanceSquared) {
#ifdef SHADOWED
    float share = i < kShadowChannels ? point.reached[i] : 1.0;
#else
    float share = 1.0;
#endif
    if (isShaped(light)) {
        vec3 toLight = way * inversesqrt(max(distanceSquared, 1e-30));
        float ofRange = min(distanceSquared, 1e37) * light.positionRest.w;
        float inCone = clamp(light.beam.w - dot(light.beam.xyz, toLight), 0.0, 1.0);
        share *= max(1.0 - ofRange * ofRange, 0.0) * inCone * inCone;
    }
    return share;
}

// Light that falls on a matt surface: what its albedo is multiplied by.
vec3 lightOn(LitPoint point) {
    vec3 light = point.openness * (kSky != 0u ? skyDiffuse(point.normal) : ambientLight());
    for (uint i = 0u; i < lightCount(); ++i) {
        LightRecord record = lightAt(i);
        vec3 way = wayTo(record, point);
        float distanceSquared = dot(way, way);
        float reach = sqrt(max(distanceSquared, 1e-30)) * (1.0 + distanceSquared * record.position.w);
        float share = shareOf(i, record, point, way, distanceSquared);
        light += record.color.rgb * (share * max(dot(point.normal, way), 0.0) / reach);
    }
    return min(light, kMostLight);
}

// Light of a sky that microfacets mirror to the camera.
vec3 mirroredSky(MetallicRoughness metallicRoughness, SkyShares shares, vec3 normal, vec3 toCamera) {
    vec3 mirrored = reflect(-toCamera, normal);
    float rough = metallicRoughness.roughness;
    float rough2 = rough * rough;
    // A level surface sees one half of the sky alone, so a rough lobe does not reach across the horizon there.
    float elevation = dot(normal, header.skyUp.xyz);
    float level = elevation * elevation;
    level *= level;
    level *= level;
    vec2 facing = vec2(elevation, rough2 * level * level);
    // A rough lobe leans from the mirrored direction to the normal; the mean of its directions need not be unit. What grazes
    // the surface leans and spreads less.
    vec3 sky = shares.mirrored * skyMirrored(mix(mirrored, normal, rough2), rough, facing) +
               shares.grazing * skyMirrored(mix(mirrored, normal, 0.2 * rough2), 0.65 * rough, facing);
    // An interpolated normal may face away from the camera; what it would mirror is behind the surface (Russell 2013).
    float horizon = 1.0 + min(dot(normal, toCamera), 0.0);
    return sky * (horizon * horizon);
}

// Light that a metallic-roughness surface sends to the camera.
vec3 glossyLight(MetallicRoughness metallicRoughness, LitPoint point) {
    vec3 toCamera = normalize(vec3(-point.ray, 1.0));
    float facing = facingOf(point.normal, toCamera);
    vec3 light;
    if (kSky != 0u) {
        SkyShares shares = skyShares(metallicRoughness, dot(point.normal, toCamera));
        light = point.openness * (shares.diffuse * skyDiffuse(point.normal) + mirroredSky(metallicRoughness, shares, point.normal, toCamera));
    } else {
        light = point.openness * ambientLight() * ambientReflectance(metallicRoughness, facing);
    }
    for (uint i = 0u; i < lightCount(); ++i) {
        LightRecord record = lightAt(i);
        vec3 way = wayTo(record, point);
        float distanceSquared = dot(way, way);
        vec3 direction = way * inversesqrt(max(distanceSquared, 1e-30));
        float share = shareOf(i, record, point, way, distanceSquared);
        light += record.color.rgb * (share / (1.0 + distanceSquared * record.position.w)) *
                 pointReflectance(metallicRoughness, point.normal, toCamera, facing, direction);
    }
    return min(light, kBrightest);
}

// What a surface of a base colour and a metallic-roughness byte, as the G-buffer has it, sends to the camera.
vec3 litColor(vec3 baseColor, uint metallicRoughness, LitPoint point) {
    return metallicRoughness == 0u ? baseColor * lightOn(point) : glossyLight(decodeMetallicRoughness(metallicRoughness, baseColor), point);
}

#endif
