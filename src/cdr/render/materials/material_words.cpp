#include <cdr/render/materials/material_words.h>
#include <cdr/shaders/shared.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cdr::render {

namespace {

/// The step of [0, 1] that is nearest to a value.
std::uint32_t stepOf(float value, std::uint32_t steps) {
    return static_cast<std::uint32_t>(
        std::lround(std::clamp(value, 0.0f, 1.0f) * static_cast<float>(steps - 1)));
}

} // namespace

MaterialWords wordsOf(const scene::Material& material) {
    const glm::vec4& color = material.baseColorFactor;
    const std::uint32_t metallicRoughness =
        material.unlit ? 0 : metallicRoughnessCode(material.metallicRoughness);
    return {.cutoffAndMetallicRoughness =
                (std::bit_cast<std::uint32_t>(material.alphaCutoff) & ~shaders::kMetallicRoughnessMask) |
                metallicRoughness,
            .baseColorRg = glm::packHalf2x16(glm::vec2(color.r, color.g)),
            .baseColorBa = glm::packHalf2x16(glm::vec2(color.b, color.a))};
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
