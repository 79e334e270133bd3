#pragma once

#include "../sources.h"

#include <cdr/host/file.h>
#include <cdr/image/codec.h>

#include <cstdint>
#include <span>
#include <string>

namespace cdr::scene::gltf {

/// An image of a file, not decoded yet. Its size is known and bounded.
struct PictureSource {
    int image = 0;
    std::string name;                         ///< what the file calls it, on one line
    host::Bytes owned{};                      ///< where a file or a URI holds it
    std::span<const std::uint8_t> inBuffer{}; ///< else
    image::PictureSize size{};

    /// How messages name it.
    std::string label() const;
    std::span<const std::uint8_t> encoded() const { return owned.empty() ? inBuffer : owned; }
    image::ImageRgba8 decode() const { return image::decodeImage(encoded(), label()); }
};

/// Reads where an image is, and how large. Refuses one that has no place or two, and what is neither PNG nor JPEG.
PictureSource readPictureSource(const Sources& sources, int image);

} // namespace cdr::scene::gltf
