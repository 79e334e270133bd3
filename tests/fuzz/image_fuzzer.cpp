#include <cdr/base/error.h>
#include <cdr/image/codec.h>

#include <cstddef>
#include <cstdint>

/// Any bytes decode, within the limits of size, or are refused with base::InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const cdr::image::ImageRgba8 image = cdr::image::decodeImage({data, size}, "a.png");
        if (image.pixels.size() != std::size_t{image.width} * image.height || image.pixels.empty() ||
            image.pixels.size() > cdr::image::kMaxDecodedPixels) {
            __builtin_trap();
        }
    } catch (const cdr::base::InputError&) {
    }
    return 0;
}
