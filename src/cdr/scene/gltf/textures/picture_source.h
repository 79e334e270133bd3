#pragma once

#include "../sources.h"

#include <cdr/image/codec.h>

#include <optional>
#include <string>

namespace cdr::scene::gltf {

/// An image of a file, not decoded yet. Its size is known and bounded; its bytes stay where they are.
struct PictureSource {
    int image = 0;
    std::string name;                     ///< what the file calls it, on one line
    std::optional<ByteSource> inBuffer{}; ///< else a file or a `data:` URI holds it
    image::PictureSize size{};

    /// How messages name it.
    std::string label() const;
};

/// Reads where an image is, and how large. Refuses one that has no place or two, and what is neither PNG nor JPEG.
PictureSource readPictureSource(const Sources& sources, int image);

/// Refuses what is damaged, or has become another picture. Threads may share the sources.
image::ImageRgba8 decodePicture(const Sources& sources, const PictureSource& picture);

} // namespace cdr::scene::gltf
