#pragma once

#include <cdr/image/image.h>
#include <cdr/scene/mesh.h>

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::platform {
class WorkerPool;
}

namespace cdr::render {

/// A texture whose alpha holds a channel of another one. Both are places in Scene::textures.
struct PackedPair {
    std::uint32_t host = 0;
    std::uint32_t guest = 0;
    std::uint32_t channel = 0; ///< of the guest

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a 0
    auto operator<=>(const PackedPair&) const = default;
};

/// Whether there are textures with which a material isPackable().
bool mayBePacked(const scene::Material& material);

/// Whether three textures can hold all five of a material. Alpha of base colour, normal and emission is free in an opaque one, so
/// it takes occlusion, metallic and roughness. That needs textures of one size, read at one place by one sampler. Guests are data.
bool isPackable(const scene::Material& material, std::span<const scene::Texture> textures);

/// Of a material that mayBePacked(): in the alpha of base colour, normal and emission, as shaders/geometry/detail.glsl reads them.
std::array<PackedPair, 3> packedPairsOf(const scene::Material& material);

/// Levels that a device has of a texture.
std::uint32_t levelsOf(const scene::Texture& texture);

/// All of them, largest first.
/// @param workers make them; null: the calling thread.
std::vector<image::ImageRgba8> allLevels(const scene::Texture& texture, platform::WorkerPool* workers);

/// Puts a channel of each guest into the alpha of the host of the same size.
void putIntoAlpha(std::vector<image::ImageRgba8>& hosts, const std::vector<image::ImageRgba8>& guests,
                  std::uint32_t channel);

} // namespace cdr::render
