#pragma once

#include <cdr/image/image.h>
#include <cdr/scene/mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::host {
class WorkerPool;
}

namespace cdr::render {

/// The textures that a packed material reads, into Scene::textures: base colour, normal, emission, occlusion, metallic and
/// roughness.
using PackKey = std::array<std::uint32_t, 5>;

/// Whether three textures can hold all five of a material. Alpha of base colour, normal and emission is free in an opaque one, so
/// it takes occlusion, metallic and roughness. That needs textures of one size, read at one place by one sampler.
bool isPackable(const scene::Material& material, std::span<const scene::Texture> textures);

/// Of a material that isPackable().
PackKey packKeyOf(const scene::Material& material);

/// Levels that a device has of a texture.
std::uint32_t levelsOf(const scene::Texture& texture);

/// All of them, largest first.
/// @param workers make them; null: the calling thread.
std::vector<image::ImageRgba8> allLevels(const scene::Texture& texture, platform::WorkerPool* workers);

/// Puts a channel of each guest into the alpha of the host of the same size.
void putIntoAlpha(std::vector<image::ImageRgba8>& hosts, const std::vector<image::ImageRgba8>& guests,
                  std::size_t channel);

} // namespace cdr::render
