#include "codec_formats.h"

#include <cdr/base/format_error.h>

#include <fmt/format.h>
#include <turbojpeg.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string_view>
#include <type_traits>

namespace cdr::image {

namespace {

/// Each 8x8 block takes at least a bit of Huffman codes. A picture that claims more is damaged, and is refused
/// before its memory is allocated. Arithmetic codes have no such bound.
constexpr std::uint64_t kMaxPixelsPerByte = std::uint64_t{8} * 64;

/// Damaged data is refused, and so are progressive files of hundreds of scans, which cost minutes to decode.
constexpr int kFlags = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;

using Decoder = std::unique_ptr<std::remove_pointer_t<tjhandle>, decltype(&tjDestroy)>;

[[noreturn]] void refuse(const Decoder& decoder, const std::string& name) {
    throw base::inputError("{}: damaged JPEG: {}", name, tjGetErrorStr2(decoder.get()));
}

Decoder makeDecoder() {
    Decoder decoder(tjInitDecompress(), &tjDestroy);
    if (!decoder) {
        throw base::RunError("JPEG: out of memory");
    }
    return decoder;
}

[[noreturn]] void refuseKind(std::string_view kind, const std::string& name) {
    throw base::inputError("{}: JPEG with {} is not supported", name, kind);
}

/// The segment that says how a picture is coded.
struct Frame {
    std::uint8_t marker = 0; ///< its second byte; 0 where no frame is found
    std::span<const std::uint8_t> payload;

    bool isArithmetic() const { return marker >= 0xc9; }
    bool isDecodable() const {
        return marker <= 0xc2 || marker == 0xc9 || marker == 0xca; // sequential and progressive
    }
};

/// Whether a second byte of a marker is that of a frame: all from 0xc0 but tables and an extension.
bool isFrame(std::uint8_t marker) {
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

bool standsAlone(std::uint8_t marker) {
    return marker <= 0x01 || (marker >= 0xd0 && marker <= 0xd8);
}

/// Skips bytes between segments, as the library does.
Frame frameOf(std::span<const std::uint8_t> encoded) {
    std::size_t at = 2;
    while (at + 4 <= encoded.size()) {
        const std::uint8_t marker = encoded[at + 1];
        if (encoded[at] != 0xff || marker == 0xff || standsAlone(marker)) {
            ++at;
            continue;
        }
        const std::size_t length = std::size_t{encoded[at + 2]} << 8u | encoded[at + 3];
        if (marker == 0xd9 || marker == 0xda || length < 2 || length > encoded.size() - at - 2) {
            break;
        }
        if (isFrame(marker)) {
            return {marker, encoded.subspan(at + 4, length - 2)};
        }
        at += 2 + length;
    }
    return {};
}

/// Whether a component's samples do not divide those of the widest, or the highest. The library cannot enlarge these.
bool hasFractionalSampling(std::span<const std::uint8_t> payload) {
    const std::span<const std::uint8_t> components =
        payload.subspan(std::min<std::size_t>(6, payload.size()));
    unsigned width = 1;
    unsigned height = 1;
    for (std::size_t at = 0; at + 3 <= components.size(); at += 3) {
        width = std::max(width, unsigned{components[at + 1]} >> 4u);
        height = std::max(height, unsigned{components[at + 1]} & 0xfu);
    }
    for (std::size_t at = 0; at + 3 <= components.size(); at += 3) {
        const unsigned across = unsigned{components[at + 1]} >> 4u;
        const unsigned down = unsigned{components[at + 1]} & 0xfu;
        if (across == 0 || down == 0) {
            return false; // damaged
        }
        if (width % across != 0 || height % down != 0) {
            return true;
        }
    }
    return false;
}

/// Sound files that the library cannot decode are not called damaged.
void requireSupported(const Frame& frame, const std::string& name) {
    if (!frame.isDecodable()) {
        refuseKind("lossless or hierarchical coding", name);
    }
    if (!frame.payload.empty() && frame.payload[0] != 8) {
        refuseKind(fmt::format("{} bits a sample", frame.payload[0]), name);
    }
    if (hasFractionalSampling(frame.payload)) {
        refuseKind("fractional sampling", name);
    }
}

/// Bounds what decoding takes.
PictureSize readHeader(const Decoder& decoder, std::span<const std::uint8_t> encoded,
                       const std::string& name) {
    // 32 bits on some platforms.
    if (encoded.size() > std::numeric_limits<unsigned long>::max()) {
        throw base::inputError("{}: JPEG of {} bytes is too large", name, encoded.size());
    }
    const Frame frame = frameOf(encoded);
    requireSupported(frame, name);
    const auto size = static_cast<unsigned long>(encoded.size());
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int colorspace = 0;
    const bool failed = tjDecompressHeader3(decoder.get(), encoded.data(), size, &width, &height,
                                            &subsampling, &colorspace) != 0;
    // A sampling that it has no name for, such as 3x1, is an error to this call alone.
    if ((failed && subsampling >= 0) || width < 1 || height < 1) {
        refuse(decoder, name);
    }
    if (colorspace == TJCS_CMYK || colorspace == TJCS_YCCK) {
        refuseKind("CMYK colours", name);
    }
    const auto columns = static_cast<std::uint32_t>(width);
    const auto rows = static_cast<std::uint32_t>(height);
    requireDecodableSize(columns, rows, name);
    if (!frame.isArithmetic() && std::uint64_t{columns} * rows / kMaxPixelsPerByte > encoded.size()) {
        throw base::inputError("{}: damaged JPEG: {} bytes cannot hold {}x{} pixels", name, encoded.size(),
                               columns, rows);
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
