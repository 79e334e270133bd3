#include <cdr/image/alpha_coverage.h>
#include <cdr/image/levels.h>
#include <cdr/image/srgb.h>
#include <cdr/platform/worker_pool.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

/// Pixels of a band of rows: worth what it costs to wake a worker.
constexpr std::size_t kBandPixels = std::size_t{1} << 14u;

std::size_t bandsOf(std::size_t width, std::size_t height) {
    return std::clamp<std::size_t>(width * height / kBandPixels, 1, height);
}

/// Calls `body` with each row. Each row is made by one worker.
template <typename Body>
void forEachRow(std::uint32_t width, std::uint32_t height, platform::WorkerPool* workers, const Body& body) {
    const std::size_t bands = workers != nullptr ? bandsOf(width, height) : 1;
    const auto makeBand = [&](std::size_t band, std::size_t) {
        const platform::IndexRange rows = platform::evenRange(height, band, bands);
        for (std::size_t y = rows.begin; y < rows.end; ++y) {
            body(static_cast<std::uint32_t>(y));
        }
    };
    if (bands == 1) {
        makeBand(0, 0);
    } else {
        workers->run(bands, makeBand);
    }
}

/// Makes levels of one picture.
class Halving {
  public:
    Halving(const LevelRules& rules, platform::WorkerPool* workers)
        : m_rules(rules),
          m_workers(workers),
          m_decode(rules.encoding) {}

    template <typename Pixel>
    LinearImage halved(const Raster<Pixel>& picture) const {
        const std::vector<Cover> columns = coversOf(picture.width);
        const std::vector<Cover> rows = coversOf(picture.height);
        LinearImage smaller(halvedSide(picture.width), halvedSide(picture.height));
        forEachRow(smaller.width, smaller.height, m_workers, [&](std::uint32_t y) {
            for (std::uint32_t x = 0; x < smaller.width; ++x) {
                smaller.at(x, y) = average(picture, columns[x], rows[y]);
            }
        });
        return smaller;
    }

    ImageRgba8 encoded(const LinearImage& linear) const {
        ImageRgba8 picture(linear.width, linear.height);
        const auto color = [&](float share) {
            return m_rules.encoding == Encoding::srgb ? srgbOfLinear(share) : byteOf(share);
        };
        forEachRow(linear.width, linear.height, m_workers, [&](std::uint32_t y) {
            for (std::uint32_t x = 0; x < linear.width; ++x) {
                const Linear& value = linear.at(x, y);
                picture.at(x, y) = {color(value[0]), color(value[1]), color(value[2]), byteOf(value[3])};
            }
        });
        return picture;
    }

  private:
    template <typename Pixel>
    Linear average(const Raster<Pixel>& picture, const Cover& column, const Cover& row) const {
        if (!m_rules.alphaWeighs) {
            return sumOf<ColorWeight::area>(picture, column, row);
        }
        const Linear sum = sumOf<ColorWeight::alpha>(picture, column, row);
        return sum[3] > 0.0f ? Linear{sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3], sum[3]}
                             : sumOf<ColorWeight::area>(picture, column, row);
    }

    /// What colours are multiplied by: the area that is covered, and alpha too. Alpha itself counts by area.
    enum class ColorWeight : std::uint8_t { area, alpha };

    template <ColorWeight Weight, typename Pixel>
    Linear sumOf(const Raster<Pixel>& picture, const Cover& column, const Cover& row) const {
        Linear sum{};
        for (std::uint32_t j = 0; j < row.count; ++j) {
            for (std::uint32_t i = 0; i < column.count; ++i) {
                const Linear value = m_decode(picture.at(column.first + i, row.first + j));
                const float area = row.weights[j] * column.weights[i];
                const float weight = Weight == ColorWeight::alpha ? area * value[3] : area;
                for (std::size_t c = 0; c < 3; ++c) {
                    sum[c] += weight * value[c];
                }
                sum[3] += area * value[3];
            }
        }
        return sum;
    }

    static std::uint8_t byteOf(float share) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0f, 1.0f) * 255.0f));
    }

    const LevelRules& m_rules;
    platform::WorkerPool* m_workers;
    LinearTable m_decode;
};

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

std::vector<ImageRgba8> smallerLevels(const ImageRgba8& picture, const LevelRules& rules, std::uint32_t most,
                                      platform::WorkerPool* workers) {
    const std::uint32_t count = levelCount(picture.width, picture.height);
    std::vector<ImageRgba8> levels;
    if (most == 0 || count < 2) {
        return levels;
    }
    const Halving halving(rules, workers);
    LinearImage linear = halving.halved(picture);
    levels.push_back(halving.encoded(linear));
    while (levels.size() < std::min(most, count - 1)) {
        linear = halving.halved(linear);
        levels.push_back(halving.encoded(linear));
    }
    if (rules.cutoff && *rules.cutoff > 0.0f && *rules.cutoff <= 1.0f) {
        keepCoverage(picture, *rules.cutoff, levels);
    }
    return levels;
}

bool areLevelsDivided(std::uint32_t width, std::uint32_t height) {
    return bandsOf(halvedSide(width), halvedSide(height)) > 1;
}

} // namespace cdr::image
