#include <cdr/image/levels.h>
#include <cdr/image/srgb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace cdr::image {

namespace {

/// Linear values.
using Linear = std::array<float, 4>;
using LinearImage = Raster<Linear>;

/// What one pixel of a halved row covers: neighbours from `first` on, and how much each counts. Their sum is 1.
struct Cover {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::array<float, 3> weights{};
};

/// A halved side of n = floor(m / 2) pixels covers m / n <= 3 pixels with each, and never touches a fourth. Where m is
/// odd, pixel i begins i / n beyond pixel 2 i, and ends (i + 1) / n beyond pixel 2 i + 2.
std::vector<Cover> coversOf(std::uint32_t side) {
    const std::uint32_t halved = halvedSide(side);
    if (side == 1) {
        return {{.first = 0, .count = 1, .weights = {1.0f}}};
    }
    std::vector<Cover> covers(halved);
    for (std::uint32_t i = 0; i < halved; ++i) {
        if (side % 2 == 0) {
            covers[i] = {.first = 2 * i, .count = 2, .weights = {0.5f, 0.5f}};
        } else {
            const auto n = static_cast<float>(halved);
            const auto whole = static_cast<float>(side);
            covers[i] = {.first = 2 * i,
                         .count = 3,
                         .weights = {static_cast<float>(halved - i) / whole, n / whole,
                                     static_cast<float>(i + 1) / whole}};
        }
    }
    return covers;
}

/// The linear values of bytes, by channel.
struct LinearTable {
    std::array<float, 256> color{};
    std::array<float, 256> share{};

    explicit LinearTable(Encoding encoding) {
        for (std::size_t i = 0; i < color.size(); ++i) {
            share[i] = static_cast<float>(i) / 255.0f;
            color[i] = encoding == Encoding::srgb ? static_cast<float>(linearOfSrgb()[i]) : share[i];
        }
    }
    Linear operator()(const Rgba8& pixel) const {
        return {color[pixel[0]], color[pixel[1]], color[pixel[2]], share[pixel[3]]};
    }
    const Linear& operator()(const Linear& pixel) const { return pixel; }
};

template <typename Pixel>
LinearImage halved(const Raster<Pixel>& picture, const LinearTable& decode) {
    const std::vector<Cover> columns = coversOf(picture.width);
    const std::vector<Cover> rows = coversOf(picture.height);
    LinearImage smaller(halvedSide(picture.width), halvedSide(picture.height));
    for (std::uint32_t y = 0; y < smaller.height; ++y) {
        for (std::uint32_t x = 0; x < smaller.width; ++x) {
            Linear& sum = smaller.at(x, y);
            for (std::uint32_t j = 0; j < rows[y].count; ++j) {
                for (std::uint32_t i = 0; i < columns[x].count; ++i) {
                    const Linear value = decode(picture.at(columns[x].first + i, rows[y].first + j));
                    const float weight = rows[y].weights[j] * columns[x].weights[i];
                    for (std::size_t c = 0; c < sum.size(); ++c) {
                        sum[c] += weight * value[c];
                    }
                }
            }
        }
    }
    return smaller;
}

std::uint8_t byteOf(float share) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0f, 1.0f) * 255.0f));
}

ImageRgba8 encoded(const LinearImage& linear, Encoding encoding) {
    ImageRgba8 picture(linear.width, linear.height);
    std::transform(linear.pixels.begin(), linear.pixels.end(), picture.pixels.begin(),
                   [&](const Linear& value) -> Rgba8 {
                       const auto color = [&](float share) {
                           return encoding == Encoding::srgb ? srgbOfLinear(share) : byteOf(share);
                       };
                       return {color(value[0]), color(value[1]), color(value[2]), byteOf(value[3])};
                   });
    return picture;
}

} // namespace

std::uint32_t halvedSide(std::uint32_t side) {
    return std::max(side / 2, 1u);
}

std::uint32_t levelCount(std::uint32_t width, std::uint32_t height) {
    if (width == 0 || height == 0) {
        return 0;
    }
    std::uint32_t count = 1;
    for (std::uint32_t side = std::max(width, height); side > 1; side = halvedSide(side)) {
        ++count;
    }
    return count;
}

std::uint64_t levelPixels(std::uint32_t width, std::uint32_t height, std::uint32_t levels) {
    std::uint64_t pixels = 0;
    for (std::uint32_t level = 0; level < levels; ++level) {
        pixels += std::uint64_t{width} * height;
        width = halvedSide(width);
        height = halvedSide(height);
    }
    return pixels;
}

std::vector<ImageRgba8> smallerLevels(const ImageRgba8& picture, Encoding encoding, std::uint32_t most) {
    const std::uint32_t count = levelCount(picture.width, picture.height);
    std::vector<ImageRgba8> levels;
    if (most == 0 || count < 2) {
        return levels;
    }
    const LinearTable decode(encoding);
    LinearImage linear = halved(picture, decode);
    levels.push_back(encoded(linear, encoding));
    while (levels.size() < std::min(most, count - 1)) {
        linear = halved(linear, decode);
        levels.push_back(encoded(linear, encoding));
    }
    return levels;
}

} // namespace cdr::image
