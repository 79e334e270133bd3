#include "codec_formats.h"

#include <cdr/base/format_error.h>

#include <spng.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <vector>

namespace cdr::image {

namespace {

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

/// Most bytes that a byte of deflate can expand to. A picture that claims more is damaged, and is refused
/// before its memory is allocated.
constexpr std::uint64_t kMaxDeflateRatio = 1032;

/// Text, profiles and other side chunks that we do not use may take this much memory together.
constexpr std::size_t kMaxChunkBytes = 16u << 20;

constexpr int kCompressionLevel = 6;

using Context = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

Context makeContext(int flags) {
    Context context(spng_ctx_new(flags), &spng_ctx_free);
    if (!context) {
        throw base::RunError("PNG: out of memory");
    }
    return context;
}

void requireDecoded(int error, const std::string& name) {
    if (error != SPNG_OK) {
        throw base::inputError("{}: damaged PNG: {}", name, spng_strerror(error));
    }
}

void requireEncoded(int error) {
    if (error != SPNG_OK) {
        throw base::runError("PNG: cannot encode: {}", spng_strerror(error));
    }
}

void requirePlausible(const spng_ihdr& header, std::size_t encodedBytes, const std::string& name) {
    requireDecodableSize(header.width, header.height, name);
    constexpr std::array<std::uint64_t, 7> kChannels{1, 1, 3, 1, 2, 1, 4};
    const std::uint64_t bits = kChannels.at(header.color_type) * header.bit_depth * header.width;
    const std::uint64_t filtered = header.height * (1 + bits / 8);
    if (filtered / kMaxDeflateRatio > encodedBytes) {
        throw base::inputError("{}: damaged PNG: {} bytes cannot hold {}x{} pixels", name, encodedBytes,
                               header.width, header.height);
    }
}

/// Starts to decode, and bounds what that takes.
spng_ihdr readHeader(const Context& context, std::span<const std::uint8_t> encoded, const std::string& name) {
    requireDecoded(spng_set_png_buffer(context.get(), encoded.data(), encoded.size()), name);
    requireDecoded(spng_set_chunk_limits(context.get(), kMaxChunkBytes, kMaxChunkBytes), name);
    spng_ihdr header{};
    requireDecoded(spng_get_ihdr(context.get(), &header), name);
    requirePlausible(header, encoded.size(), name);
    return header;
}

/// Decodes all pixels, of Texel's size.
template <class Texel>
void decodePixels(const Context& context, std::vector<Texel>& texels, spng_format format,
                  const std::string& name) {
    requireDecoded(spng_decode_image(context.get(), texels.data(), texels.size() * sizeof(Texel), format,
                                     SPNG_DECODE_TRNS),
                   name);
}

/// libspng would drop the lower bits, and so make 0 of 0x00ff, which is nearer to 1.
std::uint8_t nearestByte(std::uint16_t value) {
    return static_cast<std::uint8_t>((value * 255u + 32767u) / 65535u);
}

/// Decodes a picture of 16 bits a channel, and rounds to 8.
void decodeWidePixels(const Context& context, std::vector<Rgba8>& pixels, const std::string& name) {
    std::vector<std::array<std::uint16_t, 4>> wide(pixels.size());
    decodePixels(context, wide, SPNG_FMT_RGBA16, name);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        std::transform(wide[i].begin(), wide[i].end(), pixels[i].begin(), nearestByte);
    }
}

} // namespace

bool looksLikePng(std::span<const std::uint8_t> encoded) {
    return encoded.size() >= kSignature.size() &&
           std::equal(kSignature.begin(), kSignature.end(), encoded.begin());
}

PictureSize sizeOfPng(std::span<const std::uint8_t> encoded, const std::string& name) {
    const spng_ihdr header = readHeader(makeContext(0), encoded, name);
    return {header.width, header.height};
}

ImageRgba8 decodePng(std::span<const std::uint8_t> encoded, const std::string& name) {
    const Context context = makeContext(0);
    const spng_ihdr header = readHeader(context, encoded, name);
    ImageRgba8 image(header.width, header.height);
    if (header.bit_depth == 16) {
        decodeWidePixels(context, image.pixels, name);
    } else {
        decodePixels(context, image.pixels, SPNG_FMT_RGBA8, name);
    }
    // Reads to the end, to notice a file that is cut off after its last pixel.
    requireDecoded(spng_decode_chunks(context.get()), name);
    return image;
}

std::vector<std::uint8_t> encodePng(const ImageRgba8& image) {
    if (image.pixels.empty()) {
        throw base::InputError("PNG: the picture has no pixels");
    }
    const Context context = makeContext(SPNG_CTX_ENCODER);
    spng_ihdr header{};
    header.width = image.width;
    header.height = image.height;
    header.bit_depth = 8;
    header.color_type = SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
    requireEncoded(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1));
    requireEncoded(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, kCompressionLevel));
    requireEncoded(spng_set_ihdr(context.get(), &header));
    requireEncoded(spng_encode_image(context.get(), image.pixels.data(), image.pixels.size() * sizeof(Rgba8),
                                     SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE));
    std::size_t size = 0;
    int error = SPNG_OK;
    const std::unique_ptr<void, decltype(&std::free)> bytes(spng_get_png_buffer(context.get(), &size, &error),
                                                            &std::free);
    requireEncoded(error);
    const auto* first = static_cast<const std::uint8_t*>(bytes.get());
    return {first, first + size};
}

} // namespace cdr::image
