#include <cdr/base/error.h>
#include <cdr/image/compose.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::image {

namespace {

float toLinear(std::uint8_t value) {
    const float c = static_cast<float>(value) / 255.0f;
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t toSrgb(float linear) {
    const float c = linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(c, 0.0f, 1.0f)));
}

const std::array<float, 256>& linearTable() {
    static const std::array<float, 256> kTable = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            table[i] = toLinear(static_cast<std::uint8_t>(i));
        }
        return table;
    }();
    return kTable;
}

Rgba8 meanOfBlock(const ImageRgba8& source, std::uint32_t left, std::uint32_t top, std::uint32_t factor) {
    std::array<float, 3> sum{};
    for (std::uint32_t y = top; y < top + factor; ++y) {
        for (std::uint32_t x = left; x < left + factor; ++x) {
            for (std::size_t c = 0; c < sum.size(); ++c) {
                sum[c] += linearTable()[source.at(x, y)[c]];
            }
        }
    }
    const float scale = 1.0f / static_cast<float>(factor * factor);
    return {toSrgb(sum[0] * scale), toSrgb(sum[1] * scale), toSrgb(sum[2] * scale), 255};
}

} // namespace

ImageRgba8 shrink(const ImageRgba8& source, std::uint32_t factor) {
    if (factor < 1 || factor > source.width || factor > source.height) {
        throw base::InputError("a picture cannot be shrunk by " + std::to_string(factor));
    }
    ImageRgba8 result(source.width / factor, source.height / factor);
    for (std::uint32_t y = 0; y < result.height; ++y) {
        for (std::uint32_t x = 0; x < result.width; ++x) {
            result.at(x, y) = meanOfBlock(source, x * factor, y * factor, factor);
        }
    }
    return result;
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
