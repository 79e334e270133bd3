#include <cdr/render/materials/material_words.h>
#include <cdr/shaders/shared.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace cdr::render {

namespace {

/// The step of [0, 1] that is nearest to a value.
std::uint32_t stepOf(float value, std::uint32_t steps) {
    return static_cast<std::uint32_t>(
        std::lround(std::clamp(value, 0.0f, 1.0f) * static_cast<float>(steps - 1)));
}

/// Of a multiple of DrawRecord's steps of cutoffs, the next below. Interpolation may round the alpha that is compared with it.
float stepBelow(float cutoff) {
    const auto bits = std::bit_cast<std::uint32_t>(cutoff);
    const bool hasStep = std::isfinite(cutoff) && bits > shaders::kMetallicRoughnessMask;
    return std::bit_cast<float>(hasStep ? bits - (shaders::kMetallicRoughnessMask + 1) : bits);
}

} // namespace

float leastAlphaOf(const scene::Material& material) {
    const float alpha = material.baseColorFactor.a;
    if (alpha == 1.0f) {
        return material.alphaCutoff;
    }
    // A factor of 0 leaves only what a cutoff of 0 keeps.
    const float none = material.alphaCutoff > 0.0f ? std::numeric_limits<float>::infinity() : 0.0f;
    return alpha > 0.0f ? stepBelow(material.alphaCutoff / alpha) : none;
}

MaterialWords wordsOf(const scene::Material& material) {
    glm::vec4 color = glm::min(material.baseColorFactor, scene::kMaxBaseColor);
    float cutoff = material.alphaCutoff;
    // A half float would round the factor beside the cutoff.
    if (material.alphaMode == scene::AlphaMode::mask) {
        cutoff = leastAlphaOf(material);
        color.a = 1.0f;
    }
    const std::uint32_t metallicRoughness =
        material.unlit ? 0 : metallicRoughnessCode(material.metallicRoughness);
    return {.cutoffAndMetallicRoughness =
                (std::bit_cast<std::uint32_t>(cutoff) & ~shaders::kMetallicRoughnessMask) | metallicRoughness,
            .baseColorRg = glm::packHalf2x16(glm::vec2(color.r, color.g)),
            .baseColorBa = glm::packHalf2x16(glm::vec2(color.b, color.a))};
}

float normalScaleOf(const scene::MaterialDetail& detail) {
    return std::clamp(detail.normalScale, -scene::kMaxNormalScale, scene::kMaxNormalScale);
}

bool isMetallicRoughness(const scene::Material& material) {
    return (wordsOf(material).cutoffAndMetallicRoughness & shaders::kMetallicRoughnessMask) != 0;
}

std::uint32_t metallicRoughnessCode(const std::optional<scene::MetallicRoughness>& metallicRoughness) {
    if (!metallicRoughness) {
        return 0;
    }
    return 1 + stepOf(metallicRoughness->metallic, shaders::kMetallicSteps) * shaders::kRoughnessSteps +
           stepOf(metallicRoughness->roughness, shaders::kRoughnessSteps);
}

} // namespace cdr::render
