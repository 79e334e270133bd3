#pragma once

#include <cdr/image/codec.h>
#include <cdr/image/image.h>

#include <cstdint>
#include <span>
#include <string>

namespace cdr::image {

/// base::InputError, naming the limit, unless a picture of this size may be decoded.
void requireDecodableSize(std::uint64_t width, std::uint64_t height, const std::string& name);

// Of each format: whether the bytes start as such a file does, then sizeOfEncoded() and decodeImage() of one.

bool looksLikePng(std::span<const std::uint8_t> encoded);
PictureSize sizeOfPng(std::span<const std::uint8_t> encoded, const std::string& name);
ImageRgba8 decodePng(std::span<const std::uint8_t> encoded, const std::string& name);

bool looksLikeJpeg(std::span<const std::uint8_t> encoded);
PictureSize sizeOfJpeg(std::span<const std::uint8_t> encoded, const std::string& name);
ImageRgba8 decodeJpeg(std::span<const std::uint8_t> encoded, const std::string& name);

} // namespace cdr::image
