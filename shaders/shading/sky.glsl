// Light from all around: scene::Sky, already filtered over what a surface gathers. Define nothing; include after the
// lighting buffer. Only the sine of the elevation counts, so no map is needed: three weights of three colours.
#ifndef CDR_SHADERS_SKY_GLSL
#define CDR_SHADERS_SKY_GLSL

// How much of a cosine lobe's light comes from the zenith's share of the sky, within 2e-4 of the integral.
float zenithInCosineLobe(float elevation) { return 0.2122 + elevation / 3.0 + 0.1212 * elevation * elevation; }

vec3 skyOf(float above, float zenith) {
    return header.skyGround.rgb * (1.0 - above) + header.skyHorizon.rgb * (above - zenith) + header.skyZenith.rgb * zenith;
}

// What a white matt surface sends back.
vec3 skyDiffuse(vec3 normal) {
    float elevation = dot(normal, header.skyUp.xyz);
    return skyOf(0.5 + 0.5 * elevation, zenithInCosineLobe(elevation));
}

// What a mirror of a roughness sees about a direction, which may be shorter than 1. This is a fit to the integral over the
// lobe of GGX, seen along its normal as is usual (Karis 2013). The horizon's step is off by up to 0.07, the slope above it
// by up to 0.03.
// facing: of the surface, the sine of its elevation and the share of the lobe that its plane cuts off, where it is level.
vec3 skyMirrored(vec3 direction, float roughness, vec2 facing) {
    float elevation = dot(direction, header.skyUp.xyz);
    float width = max(1.3 * smoothstep(0.0, 0.95, roughness), 0.01);
    float above = mix(smoothstep(-width, width, elevation), step(0.0, facing.x), facing.y);
    float soft = 0.6 * roughness + 1e-3;
    float past = max(elevation + soft, 0.0);
    float slope = elevation >= soft ? elevation : past * past / (4.0 * soft);
    float zenith = mix(slope, zenithInCosineLobe(elevation), smoothstep(0.1, 1.05, roughness));
    return skyOf(above, min(zenith, above));
}

#endif
