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

// Light that falls on a point `ahead` of an anchor plane (a float and its rest), view-space x and y `across`.
vec3 lightOn(vec3 normal, vec2 across, vec2 anchor, float ahead) {
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
    return light;
}

#endif
