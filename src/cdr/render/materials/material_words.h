#pragma once

#include <cdr/scene/mesh.h>

#include <cstdint>
#include <optional>

namespace cdr::render {

/// shaders::DrawRecord's words of a material.
struct MaterialWords {
    std::uint32_t cutoffAndMetallicRoughness = 0;
    std::uint32_t baseColorRg = 0;
    std::uint32_t baseColorBa = 0;
};

/// What a mask keeps: the least alpha of texture times vertex, that is the cutoff over the factor. Infinite where it keeps nothing.
float leastAlphaOf(const scene::Material& material);

/// The alpha cutoff loses the last 8 bits of its mantissa, towards 0. That of a mask is leastAlphaOf(), and its factor's alpha
/// counts as 1. An unlit material counts as matt.
MaterialWords wordsOf(const scene::Material& material);

/// MaterialDetail::normalScale within its bounds.
float normalScaleOf(const scene::MaterialDetail& detail);

/// Whether a surface of it does.
bool isMetallicRoughness(const scene::Material& material);

/// Metallic and roughness as the G-buffer has them (shaders::kMetallicSteps): 0 for matt, at most shaders::kMetallicRoughnessMask. Values
/// outside [0, 1] count as its ends.
std::uint32_t metallicRoughnessCode(const std::optional<scene::MetallicRoughness>& metallicRoughness);

} // namespace cdr::render
