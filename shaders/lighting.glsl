// Ambient and point lights on a surface, for the deferred pass and for what is drawn after it. Define LIGHTING_SET and
// LIGHTING_BINDING first. Knows view distances, not how they were mapped to depth.
#ifndef CDR_SHADERS_LIGHTING_GLSL
#define CDR_SHADERS_LIGHTING_GLSL

layout(set = LIGHTING_SET, binding = LIGHTING_BINDING, std430) readonly buffer Lighting {
    ShadingHeader header;
    LightRecord lights[];
};

// View-space x and y per unit of view distance at a pixel.
vec2 rayAt(vec2 pixel, vec2 pictureSize) {
    return (pixel / pictureSize * 2.0 - 1.0) * vec2(1.0, -1.0) * header.rayScale;
}

// Difference of two view distances, each an anchor plane (a float and its rest) and what lies ahead of it.
float distanceBetween(vec2 fromAnchor, float fromAhead, vec2 toAnchor, float toAhead) {
    return (toAnchor.x - fromAnchor.x) + (toAnchor.y - fromAnchor.y) + (toAhead - fromAhead);
}

// What a colour becomes through the fog between the camera and a point on a ray.
vec3 throughFog(vec3 color, vec2 ray, float distanceView) {
    float distance = distanceView * length(vec3(ray, 1.0));
    return mix(header.fog.rgb, color, exp(-header.fog.a * distance));
}

// Light that falls on a point `ahead` of an anchor plane (a float and its rest), view-space x and y `across`.
// openness: the share of ambient light that reaches it.
vec3 lightOn(vec3 normal, vec2 across, vec2 anchor, float ahead, float openness) {
    vec3 light = openness * header.ambient.rgb;
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
    return light;
}

#endif
