#include "codec_formats.h"

#include <cdr/base/format_error.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>

namespace cdr::image {

void requireDecodableSize(std::uint64_t width, std::uint64_t height, const std::string& name) {
    if (width == 0 || height == 0) {
        throw base::inputError("{}: the picture has no pixels", name);
    }
    if (width > kMaxDecodedSide || height > kMaxDecodedSide || width * height > kMaxDecodedPixels) {
        throw base::inputError("{}: {}x{} pixels is over the limit of {} a side and {} in all", name, width,
                               height, kMaxDecodedSide, kMaxDecodedPixels);
    }
}

ImageRgba8 decodeImage(std::span<const std::uint8_t> encoded, const std::string& name) {
    if (looksLikePng(encoded)) {
        return decodePng(encoded, name);
    }
    if (looksLikeJpeg(encoded)) {
        return decodeJpeg(encoded, name);
    }
    throw base::inputError("{}: neither PNG nor JPEG", name);
}

PictureSize sizeOfEncoded(std::span<const std::uint8_t> encoded, const std::string& name) {
    if (looksLikePng(encoded)) {
        return sizeOfPng(encoded, name);
    }
    if (looksLikeJpeg(encoded)) {
        return sizeOfJpeg(encoded, name);
    }
    throw base::inputError("{}: neither PNG nor JPEG", name);
}

std::vector<std::uint8_t> encodeImage(const std::filesystem::path& path, const ImageRgba8& image) {
    requireEncodable(path);
    return platform::lowerExtension(path) == ".png" ? encodePng(image) : encodeTga(image);
}

void requireEncodable(const std::filesystem::path& path) {
    const std::string extension = platform::lowerExtension(path);
    if (extension != ".png" && extension != ".tga") {
        throw base::inputError("{}: cannot write '{}' pictures, use .png or .tga", path.string(), extension);
    }
}

void writeImage(const std::filesystem::path& path, const ImageRgba8& image) {
    platform::writeFile(path, encodeImage(path, image));
}

} // namespace cdr::image
