#pragma once

#include <cdr/image/codec.h>

#include <cstdint>
#include <span>
#include <vector>

namespace cdr::scene::gltf {

/// A texture before it has pixels.
struct TextureNeed {
    image::PictureSize size;
    bool hasLevels = true; ///< what draws it makes its smaller levels
};

/// What textures take on a device, 4 bytes a pixel, levels included.
/// @param dropped how many of each one's largest levels are left out.
std::uint64_t textureBytes(std::span<const TextureNeed> textures, std::span<const std::uint32_t> dropped);

/// How many of each texture's largest levels to leave out, so that all fit. The texture that takes most gives up a level,
/// again and again; of those alike, the first. None goes below one pixel, so many textures may take more even so.
std::vector<std::uint32_t> levelsToDrop(std::span<const TextureNeed> textures, std::uint64_t bytes);

} // namespace cdr::scene::gltf
