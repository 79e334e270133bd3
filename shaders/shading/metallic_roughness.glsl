// How surfaces reflect light that are not matt: the metallic-roughness material of glTF 2.0 (specification, appendix B). It is a mix of
// a dielectric and a metal as in B.2. B.3.5 lets the metal's Fresnel term dim the dielectric's diffuse light too, which
// takes the colour out of half metals. The microfacets are those of Walter et al. 2007, "Microfacet Models for Refraction
// through Rough Surfaces" (GGX). The shadowing between them is Smith's, in the height-correlated form of Heitz 2014. The
// Fresnel term is that of Schlick 1994. All reflectances are times pi, as a light's colour is what a white matt surface
// that faces it sends back.
#ifndef CDR_SHADERS_METALLIC_ROUGHNESS_GLSL
#define CDR_SHADERS_METALLIC_ROUGHNESS_GLSL

#include "shared.h"
#include "shading/brightest.glsl"

const float kDielectric = 0.04; // what a dielectric mirrors at normal incidence
// Lights are points: what is smoother would show a highlight smaller than a pixel.
const float kMinRoughness = 0.08;

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
    vec3 sum = toCamera + toLight; // 0 for a light straight behind the surface
    if (lambert <= 0.0 || sum == vec3(0.0)) {
        return vec3(0.0);
    }
    vec3 halfway = normalize(sum);
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

// Share of light that is the same from everywhere. What microfacets mirror of it is Karis 2014's fit, "Physically Based
// Shading on Mobile"; the rest is diffuse.
vec3 ambientReflectance(MetallicRoughness metallicRoughness, float facing) {
    vec4 r = metallicRoughness.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float grazing = min(r.x * r.x, exp2(-9.28 * facing)) * r.x + r.y;
    vec2 scaleAndBias = vec2(-1.04, 1.04) * grazing + r.zw;
    vec3 mirrored = max(metallicRoughness.mirror * scaleAndBias.x + scaleAndBias.y, 0.0);
    return (1.0 - (kDielectric * scaleAndBias.x + scaleAndBias.y)) * metallicRoughness.diffuse + mirrored;
}

// Shares of a sky that reach the camera. diffuse: of diffuse light. mirrored: of directions about a lobe's mean, as
// microfacets mirror them. grazing: of directions that graze the surface, by what Fresnel's term adds at a low angle.
struct SkyShares {
    vec3 diffuse;
    vec3 mirrored;
    float grazing;
};

// Polynomials of the roughness, whose values the powers 2, 4, 8 and 16 of the angle's measure are multiplied by. Fitted to the
// integral over all directions (Karis 2013's split sum, with the terms of pointReflectance()) by least squares over roughness
// 0.08 to 1. Off by 0.002 and 0.001 on average, where facing is above 0.05 by 0.016 at most. Karis' fit is off by 0.12 and 0.42.
const vec4 kMirroredOf[6] = vec4[](
    vec4(-0.0937, -1.0113, 0.9799, -1.1259), vec4(0.9454, 11.6247, -34.0978, 25.5773),
    vec4(3.8281, -92.0494, 213.8968, -130.3529), vec4(-37.6604, 273.8897, -507.7807, 272.3212),
    vec4(65.6353, -322.1061, 514.5350, -253.0801), vec4(-32.1296, 129.4820, -187.3307, 86.7074));
const vec4 kGrazingOf[6] = vec4[](
    vec4(0.0921, -0.0419, 1.5515, -0.4913), vec4(-1.9978, 9.6029, -9.4072, -1.7751),
    vec4(9.4920, -39.3222, 10.7372, 24.5065), vec4(-17.5537, 60.3744, 16.5902, -64.7135),
    vec4(14.2640, -40.6008, -36.5732, 66.3989), vec4(-4.2890, 9.9994, 17.1308, -23.9292));
vec4 polynomial(const vec4 of[6], float x) {
    return of[0] + x * (of[1] + x * (of[2] + x * (of[3] + x * (of[4] + x * of[5]))));
}
// cosine: between the normal and the way to the camera, below 0 where an interpolated normal faces away.
SkyShares skyShares(MetallicRoughness metallicRoughness, float cosine) {
    float rough = metallicRoughness.roughness;
    float away = 1.0 - clamp(cosine, 1e-3, 1.0);
    float away2 = away * away;
    float away4 = away2 * away2;
    float away8 = away4 * away4;
    vec4 angle = vec4(away2, away4, away8, away8 * away8);
    float alongNormal = 1.0343 + rough * (-0.6172 + rough * (3.5317 + rough * (-7.9479 + rough * (5.0280 - 0.7027 * rough))));
    float mirrored = clamp(alongNormal + dot(angle, polynomial(kMirroredOf, rough)), 0.0, 1.0);
    float grazing = max(dot(angle, polynomial(kGrazingOf, rough)), 0.0);
    // What Schlick's term leaves of diffuse light depends on the halfway vector, not on the roughness. Within 0.001 down to a
    // cosine of -0.4, within 0.006 down to -0.6.
    float unmirrored = 0.9332 + cosine * (0.0726 + cosine * (0.0222 * cosine - 0.068));
    return SkyShares(unmirrored * metallicRoughness.diffuse, metallicRoughness.mirror * mirrored, grazing);
}

#endif
