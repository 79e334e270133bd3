#pragma once

#include <cdr/image/codec.h>
#include <cdr/image/image.h>

#include <cstdint>
#include <span>
#include <string>

namespace cdr::image {

/// Whether the bytes start as a PNG file does.
bool looksLikePng(std::span<const std::uint8_t> encoded);

/// sizeOfEncoded() of a PNG.
PictureSize sizeOfPng(std::span<const std::uint8_t> encoded, const std::string& name);

/// decodeImage() of a PNG.
ImageRgba8 decodePng(std::span<const std::uint8_t> encoded, const std::string& name);

} // namespace cdr::image
