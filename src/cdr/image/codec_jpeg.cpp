#include "codec_jpeg.h"

#include "codec_limits.h"

#include <cdr/base/error.h>

#include <fmt/format.h>
#include <turbojpeg.h>

#include <limits>
#include <memory>
#include <type_traits>

namespace cdr::image {

namespace {

/// Each 8x8 block takes at least a bit. A picture that claims more is damaged, and is refused before its
/// memory is allocated.
constexpr std::uint64_t kMaxPixelsPerByte = std::uint64_t{8} * 64;

/// Damaged data is refused, and so are progressive files of hundreds of scans, which cost minutes to decode.
constexpr int kFlags = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;

using Decoder = std::unique_ptr<std::remove_pointer_t<tjhandle>, decltype(&tjDestroy)>;

[[noreturn]] void refuse(const Decoder& decoder, const std::string& name) {
    throw base::InputError(fmt::format("{}: damaged JPEG: {}", name, tjGetErrorStr2(decoder.get())));
}

Decoder makeDecoder() {
    Decoder decoder(tjInitDecompress(), &tjDestroy);
    if (!decoder) {
        throw base::RunError("JPEG: out of memory");
    }
    return decoder;
}

/// Bounds what decoding takes.
PictureSize readHeader(const Decoder& decoder, std::span<const std::uint8_t> encoded,
                       const std::string& name) {
    // 32 bits on some platforms.
    if (encoded.size() > std::numeric_limits<unsigned long>::max()) {
        throw base::InputError(fmt::format("{}: JPEG of {} bytes is too large", name, encoded.size()));
    }
    const auto size = static_cast<unsigned long>(encoded.size());
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int colorspace = 0;
    if (tjDecompressHeader3(decoder.get(), encoded.data(), size, &width, &height, &subsampling,
                            &colorspace) != 0 ||
        width < 1 || height < 1) {
        refuse(decoder, name);
    }
    const auto columns = static_cast<std::uint32_t>(width);
    const auto rows = static_cast<std::uint32_t>(height);
    requireDecodableSize(columns, rows, name);
    if (std::uint64_t{columns} * rows / kMaxPixelsPerByte > encoded.size()) {
        throw base::InputError(fmt::format("{}: damaged JPEG: {} bytes cannot hold {}x{} pixels", name,
                                           encoded.size(), columns, rows));
    }
    return {columns, rows};
}

} // namespace

bool looksLikeJpeg(std::span<const std::uint8_t> encoded) {
    return encoded.size() >= 3 && encoded[0] == 0xff && encoded[1] == 0xd8 && encoded[2] == 0xff;
}

PictureSize sizeOfJpeg(std::span<const std::uint8_t> encoded, const std::string& name) {
    return readHeader(makeDecoder(), encoded, name);
}

ImageRgba8 decodeJpeg(std::span<const std::uint8_t> encoded, const std::string& name) {
    const Decoder decoder = makeDecoder();
    const PictureSize size = readHeader(decoder, encoded, name);
    ImageRgba8 image(size.width, size.height);
    if (tjDecompress2(decoder.get(), encoded.data(), static_cast<unsigned long>(encoded.size()),
                      image.pixels.front().data(), static_cast<int>(size.width), 0,
                      static_cast<int>(size.height), TJPF_RGBA, kFlags) != 0) {
        refuse(decoder, name);
    }
    return image;
}

} // namespace cdr::image
