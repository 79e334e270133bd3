#include <cdr/base/error.h>
#include <cdr/image/compose.h>
#include <cdr/image/srgb.h>

#include <algorithm>
#include <array>

namespace cdr::image {

namespace {

Rgba8 meanOfBlock(const ImageRgba8& source, std::uint32_t left, std::uint32_t top, std::uint32_t factor) {
    std::array<double, 3> sum{};
    for (std::uint32_t y = top; y < top + factor; ++y) {
        for (std::uint32_t x = left; x < left + factor; ++x) {
            for (std::size_t c = 0; c < sum.size(); ++c) {
                sum[c] += linearOfSrgb()[source.at(x, y)[c]];
            }
        }
    }
    const double scale = 1.0 / (static_cast<double>(factor) * factor);
    return {srgbOfLinear(sum[0] * scale), srgbOfLinear(sum[1] * scale), srgbOfLinear(sum[2] * scale), 255};
}

} // namespace

ImageRgba8 shrink(const ImageRgba8& source, std::uint32_t factor) {
    if (factor < 1 || factor > source.width || factor > source.height) {
        throw base::InputError("a picture cannot be shrunk by " + std::to_string(factor));
    }
    return rasterOf<Rgba8>(source.width / factor, source.height / factor, [&](auto x, auto y) {
        return meanOfBlock(source, x * factor, y * factor, factor);
    });
}

std::uint32_t shrinkFactor(const ImageRgba8& source, std::uint32_t width) {
    return std::max(1u, std::min(source.width / width, source.height));
}

void paste(ImageRgba8& target, const ImageRgba8& source, std::uint32_t x, std::uint32_t y) {
    if (x >= target.width || y >= target.height) {
        return;
    }
    const std::uint32_t width = std::min(source.width, target.width - x);
    const std::uint32_t height = std::min(source.height, target.height - y);
    for (std::uint32_t row = 0; row < height; ++row) {
        std::copy_n(&source.at(0, row), width, &target.at(x, y + row));
    }
}

} // namespace cdr::image
