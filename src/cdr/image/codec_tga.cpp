#include <cdr/base/format_error.h>
#include <cdr/image/codec.h>

#include <array>
#include <limits>

namespace cdr::image {

namespace {

constexpr std::size_t kHeaderBytes = 18;
constexpr std::uint8_t kUncompressedTrueColor = 2;
constexpr std::uint8_t kBitsPerPixel = 24;
constexpr std::uint8_t kRowsFromTop = 0x20;

std::array<std::uint8_t, kHeaderBytes> makeHeader(std::uint32_t width, std::uint32_t height) {
    std::array<std::uint8_t, kHeaderBytes> header{};
    header[2] = kUncompressedTrueColor;
    header[12] = static_cast<std::uint8_t>(width & 0xff);
    header[13] = static_cast<std::uint8_t>(width >> 8);
    header[14] = static_cast<std::uint8_t>(height & 0xff);
    header[15] = static_cast<std::uint8_t>(height >> 8);
    header[16] = kBitsPerPixel;
    header[17] = kRowsFromTop;
    return header;
}

} // namespace

std::vector<std::uint8_t> encodeTga(const ImageRgba8& image) {
    constexpr std::uint32_t kMaxSide = std::numeric_limits<std::uint16_t>::max();
    if (image.pixels.empty() || image.width > kMaxSide || image.height > kMaxSide) {
        throw base::inputError("TGA: {}x{} pixels, a side must be 1 to {}", image.width, image.height,
                               kMaxSide);
    }
    const std::array<std::uint8_t, kHeaderBytes> header = makeHeader(image.width, image.height);
    std::vector<std::uint8_t> bytes(header.begin(), header.end());
    bytes.reserve(kHeaderBytes + image.pixels.size() * 3);
    for (const Rgba8& pixel : image.pixels) {
        bytes.insert(bytes.end(), {pixel[2], pixel[1], pixel[0]});
    }
    return bytes;
}

} // namespace cdr::image
