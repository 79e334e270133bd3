#pragma once

#include <cdr/scene/mesh.h>

#include <cstdint>
#include <optional>

namespace cdr::render {

/// shaders::DrawRecord's words of a material.
struct MaterialWords {
    std::uint32_t cutoffAndShine = 0;
    std::uint32_t baseColorRg = 0;
    std::uint32_t baseColorBa = 0;
};

/// The alpha cutoff loses the last 8 bits of its mantissa, towards 0. An unlit material does not shine.
MaterialWords wordsOf(const scene::Material& material);

/// Whether a surface of it does.
bool shines(const scene::Material& material);

/// A shine as the G-buffer has it (shaders::kMetallicSteps): 0 for matt, at most shaders::kShineMask. Values
/// outside [0, 1] count as its ends.
std::uint32_t shineCode(const std::optional<scene::Shine>& shine);

} // namespace cdr::render
