// What a material has beside its factors, read from its textures. Define DETAIL_SET, DETAIL_CONSTANT and baseColorTexture first.
// With kDetailPacked three textures hold all five. The compiler merges reads of one texture at one place.
#ifndef CDR_SHADERS_DETAIL_GLSL
#define CDR_SHADERS_DETAIL_GLSL

#include "shading/cheap_division.glsl"

layout(constant_id = DETAIL_CONSTANT) const uint kDetail = 0u; // kDetailMetallicRoughness and its siblings

layout(set = DETAIL_SET, binding = 0) uniform sampler2D metallicRoughnessTexture;
layout(set = DETAIL_SET, binding = 1) uniform sampler2D normalTexture;
layout(set = DETAIL_SET, binding = 2) uniform sampler2D occlusionTexture;
layout(set = DETAIL_SET, binding = 3) uniform sampler2D emissiveTexture;
layout(set = DETAIL_SET, binding = 4, std140) uniform Detail { DetailRecord detail; };

bool has(uint part) { return (kDetail & part) != 0u; }

// Where a texture is read, of both places of a vertex.
vec2 placeOf(uint part, vec4 places) {
    if (has(kDetailPacked)) {
        return places.xy;
    }
    vec2 place = (detail.secondPlaces & part) != 0u ? places.zw : places.xy;
    if (has(kDetailMoved)) {
        uint texture = part == kDetailMetallicRoughness ? 0u : part == kDetailNormal ? 1u : part == kDetailOcclusion ? 2u : 3u;
        vec4 turn = detail.turns[texture];
        place = turn.xy * place.x + turn.zw * place.y + detail.offsets[texture].xy;
    }
    return place;
}

// The normal of a front, in the space of both vectors, which need not be unit.
vec3 detailNormal(vec3 normal, vec4 tangent, vec4 places) {
    if (!has(kDetailNormal)) {
        return normal;
    }
    vec3 n = unit(normal);
    vec3 t = unit(tangent.xyz);
    vec3 bumped = texture(normalTexture, placeOf(kDetailNormal, places)).xyz * 2.0 - 1.0;
    bumped.xy *= detail.emissionAndNormalScale.w;
    return bumped.x * t + bumped.y * (tangent.w * cross(n, t)) + bumped.z * n;
}

// Metallic and roughness, each in [0, 1].
vec2 detailMetallicRoughness(vec4 places) {
    vec2 metallicRoughness = detail.metallicRoughnessAndOcclusion.xy;
    if (!has(kDetailMetallicRoughness)) {
        return metallicRoughness;
    }
    if (has(kDetailPacked)) {
        return metallicRoughness * vec2(texture(normalTexture, places.xy).a, texture(emissiveTexture, places.xy).a);
    }
    return metallicRoughness * texture(metallicRoughnessTexture, placeOf(kDetailMetallicRoughness, places)).bg;
}

// As the G-buffer has it, in the last byte.
uint metallicRoughnessCode(vec2 metallicRoughness) {
    uvec2 steps = uvec2(round(metallicRoughness * vec2(float(kMetallicSteps - 1u), float(kRoughnessSteps - 1u))));
    return 1u + steps.x * kRoughnessSteps + steps.y;
}

// The share of ambient light that arrives.
float detailOpenness(vec4 places) {
    if (!has(kDetailOcclusion)) {
        return 1.0;
    }
    float share = has(kDetailPacked)   ? texture(baseColorTexture, places.xy).a
                  : has(kDetailShared) ? texture(metallicRoughnessTexture, placeOf(kDetailMetallicRoughness, places)).r
                                       : texture(occlusionTexture, placeOf(kDetailOcclusion, places)).r;
    return mix(1.0, share, detail.metallicRoughnessAndOcclusion.z);
}

// Linear light that the surface sends by itself.
vec3 detailEmission(vec4 places) {
    if (!has(kDetailEmits)) {
        return vec3(0.0);
    }
    vec3 emission = detail.emissionAndNormalScale.rgb;
    return has(kDetailEmissive) ? emission * texture(emissiveTexture, placeOf(kDetailEmissive, places)).rgb : emission;
}

#endif
