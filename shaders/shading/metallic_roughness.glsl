// How surfaces reflect light that are not matt: the metallic-roughness material of glTF 2.0 (specification, appendix B). It is a mix of
// a dielectric and a metal as in B.2. B.3.5 lets the metal's Fresnel term dim the dielectric's diffuse light too, which
// takes the colour out of half metals. The microfacets are those of Walter et al. 2007, "Microfacet Models for Refraction
// through Rough Surfaces" (GGX). The shadowing between them is Smith's, in the height-correlated form of Heitz 2014. The
// Fresnel term is that of Schlick 1994. All reflectances are times pi, as a light's colour is what a white matt surface
// that faces it sends back.
#ifndef CDR_SHADERS_METALLIC_ROUGHNESS_GLSL
#define CDR_SHADERS_METALLIC_ROUGHNESS_GLSL

#include "shared.h"

const float kDielectric = 0.04; // what a dielectric mirrors at normal incidence
// Lights are points: what is smoother would show a highlight smaller than a pixel.
const float kMinRoughness = 0.08;
// Half floats, and their sums where surfaces blend, must hold what a surface sends.
const float kBrightest = 16.0;

struct MetallicRoughness {
    vec3 diffuse; // albedo of what a dielectric does not mirror, times its share in the mix
    vec3 mirror;  // what the mix mirrors at normal incidence
    float roughness;
};

// code: as shared.h has it, not 0.
MetallicRoughness decodeMetallicRoughness(uint code, vec3 baseColor) {
    uint steps = code - 1u;
    float metallic = float(steps / kRoughnessSteps) / float(kMetallicSteps - 1u);
    float roughness = float(steps % kRoughnessSteps) / float(kRoughnessSteps - 1u);
    return MetallicRoughness(baseColor * (1.0 - metallic), mix(vec3(kDielectric), baseColor, metallic),
                 max(roughness, kMinRoughness));
}

// Cosine between a normal and the way to the camera; above 0, since interpolated normals may face away a little.
float facingOf(vec3 normal, vec3 toCamera) { return max(dot(normal, toCamera), 1e-3); }

// Share of a point light's colour that reaches the camera.
vec3 pointReflectance(MetallicRoughness metallicRoughness, vec3 normal, vec3 toCamera, float facing, vec3 toLight) {
    float lambert = dot(normal, toLight);
    if (lambert <= 0.0) {
        return vec3(0.0);
    }
    vec3 halfway = normalize(toCamera + toLight);
    float alpha = metallicRoughness.roughness * metallicRoughness.roughness;
    float alpha2 = alpha * alpha;
    // The sine of the halfway vector's angle, not 1 less the cosine, which would cancel where highlights are.
    vec3 sine = cross(normal, halfway);
    float spread = alpha2 + dot(sine, sine) * (1.0 - alpha2);
    float facets = alpha2 / (spread * spread);
    float visible = 0.5 / (lambert * sqrt(facing * facing * (1.0 - alpha2) + alpha2) +
                           facing * sqrt(lambert * lambert * (1.0 - alpha2) + alpha2));
    float grazing = 1.0 - clamp(dot(toCamera, halfway), 0.0, 1.0);
    float grazing5 = grazing * grazing * grazing * grazing * grazing;
    vec3 mirrored = mix(metallicRoughness.mirror, vec3(1.0), grazing5) * (facets * visible);
    return lambert * ((1.0 - mix(kDielectric, 1.0, grazing5)) * metallicRoughness.diffuse + mirrored);
}

// Shares of ambient light that reach the camera. What microfacets mirror of it is Karis 2014's fit, "Physically Based
// Shading on Mobile"; the rest is diffuse.
struct AmbientShares {
    vec3 diffuse;
    vec3 mirrored;
};
AmbientShares ambientShares(MetallicRoughness metallicRoughness, float facing) {
    vec4 r = metallicRoughness.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float grazing = min(r.x * r.x, exp2(-9.28 * facing)) * r.x + r.y;
    vec2 scaleAndBias = vec2(-1.04, 1.04) * grazing + r.zw;
    vec3 mirrored = max(metallicRoughness.mirror * scaleAndBias.x + scaleAndBias.y, 0.0);
    return AmbientShares((1.0 - (kDielectric * scaleAndBias.x + scaleAndBias.y)) * metallicRoughness.diffuse, mirrored);
}

// The same, fitted to the integral itself (Karis 2013's split sum, with the terms of pointReflectance()). The fit is least
// squares over roughness 0.08 to 1 and all angles. Off by 0.009 on average, by 0.065 at most, where Karis' fit is by 0.12
// and 0.42.
const mat4 kMirroredScale = mat4(1.4878, -1.3415, 0.7893, -1.8011,
                              -6.4337, 18.2337, -11.2007, 9.8790,
                              12.4680, -38.2377, 24.2537, -15.5164,
                              -6.9815, 21.1888, -13.9526, 7.7799);
const mat4 kMirroredBias = mat4(0.0473, -0.1946, 0.1579, 1.1907,
                              2.1540, -5.2277, 3.1204, -5.8885,
                              -5.4206, 13.6777, -8.4302, 9.4876,
                              3.2737, -8.3962, 5.2408, -4.8045);
AmbientShares skyShares(MetallicRoughness metallicRoughness, float facing) {
    float roughness2 = metallicRoughness.roughness * metallicRoughness.roughness;
    float away = 1.0 - min(facing, 1.0);
    vec4 rough = vec4(1.0, metallicRoughness.roughness, roughness2, roughness2 * metallicRoughness.roughness);
    vec4 angle = vec4(1.0, facing, facing * facing, away * away * away * away * away);
    float scale = clamp(dot(angle, kMirroredScale * rough), 0.0, 1.0);
    float bias = max(dot(angle, kMirroredBias * rough), 0.0);
    return AmbientShares((1.0 - (kDielectric * scale + bias)) * metallicRoughness.diffuse, metallicRoughness.mirror * scale + bias);
}

// Of light that is the same from everywhere.
vec3 ambientReflectance(MetallicRoughness metallicRoughness, float facing) {
    AmbientShares shares = ambientShares(metallicRoughness, facing);
    return shares.diffuse + shares.mirrored;
}

#endif
