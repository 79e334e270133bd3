#pragma once

#include <cdr/image/image.h>
#include <cdr/image/picture_size.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace cdr::image {

/// Largest side of a picture this library decodes, in pixels.
inline constexpr std::uint32_t kMaxDecodedSide = 16384;
/// Most pixels of a picture this library decodes: 4 bytes each, so 256 MiB.
inline constexpr std::uint64_t kMaxDecodedPixels = 64ull << 20;

/// Decodes a PNG or JPEG, recognised by its first bytes, to 8-bit RGBA. Alpha is 255 where the file has none.
/// base::InputError for anything else, a damaged file, or one over the limits above.
/// @param name of the file, which the message begins with.
ImageRgba8 decodeImage(std::span<const std::uint8_t> encoded, const std::string& name);

/// The size that decodeImage() would give, by the header alone. base::InputError for what the header shows to be no
/// picture, or over the limits above.
PictureSize sizeOfEncoded(std::span<const std::uint8_t> encoded, const std::string& name);

/// A named 32-bit float channel of an EXR file.
struct ExrChannel {
    std::string name;
    ImageFloat values;
};

std::vector<std::uint8_t> encodePng(const ImageRgba8& image);
/// 24-bit uncompressed TGA (the thesis' frame format); alpha is dropped.
std::vector<std::uint8_t> encodeTga(const ImageRgba8& image);

/// PNG or TGA by the extension of `path`, which names the file in messages. InputError for another extension.
std::vector<std::uint8_t> encodeImage(const std::filesystem::path& path, const ImageRgba8& image);
/// 32-bit float channels, all of one size, as OpenEXR. InputError, which begins with `path`, for unusable channels.
std::vector<std::uint8_t> encodeExr(const std::filesystem::path& path, std::span<const ExrChannel> channels);

/// InputError unless writeImage() knows the extension. Call it before long work.
void requireEncodable(const std::filesystem::path& path);

/// Writes `path` as PNG or TGA by its extension, whole or not at all. InputError for another extension.
void writeImage(const std::filesystem::path& path, const ImageRgba8& image);

} // namespace cdr::image
