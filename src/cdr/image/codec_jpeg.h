#pragma once

#include <cdr/image/codec.h>
#include <cdr/image/image.h>

#include <cstdint>
#include <span>
#include <string>

namespace cdr::image {

/// Whether the bytes start as a JPEG file does.
bool looksLikeJpeg(std::span<const std::uint8_t> encoded);

/// sizeOfEncoded() of a JPEG.
PictureSize sizeOfJpeg(std::span<const std::uint8_t> encoded, const std::string& name);

/// decodeImage() of a JPEG.
ImageRgba8 decodeJpeg(std::span<const std::uint8_t> encoded, const std::string& name);

} // namespace cdr::image
