#include <cdr/image/alpha_coverage.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace cdr::image {

namespace {

/// Samples of a pixel: half-way to each of its corners, interpolated as textures are read.
constexpr std::size_t kSamples = 4;

/// By alpha from 0 to 256, how many samples have at least that.
std::array<std::size_t, 257> samplesFrom(const ImageRgba8& picture) {
    std::array<std::size_t, 257> counts{};
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            for (const std::uint32_t y2 : {y > 0 ? y - 1 : y, std::min(y + 1, picture.height - 1)}) {
                for (const std::uint32_t x2 : {x > 0 ? x - 1 : x, std::min(x + 1, picture.width - 1)}) {
                    const unsigned sum = 9u * picture.at(x, y)[3] + 3u * picture.at(x2, y)[3] +
                                         3u * picture.at(x, y2)[3] + picture.at(x2, y2)[3];
                    ++counts[(sum + 8u) / 16u];
                }
            }
        }
    }
    for (std::size_t alpha = 256; alpha > 0; --alpha) {
        counts[alpha - 1] += counts[alpha];
    }
    return counts;
}

/// The alpha from which a level's samples must be kept, so that their share is the wanted one; 1 to 256.
std::size_t keptFrom(const ImageRgba8& level, double wanted, std::size_t cutoff) {
    const auto counts = samplesFrom(level);
    const auto samples = static_cast<double>(kSamples * level.pixels.size());
    const auto error = [&](std::size_t from) {
        return std::abs(static_cast<double>(counts[from]) - wanted * samples);
    };
    std::size_t best = cutoff;
    for (std::size_t step = 1; step < 256; ++step) { // outwards, so that of equals the nearest is found first
        for (const std::size_t from :
             {cutoff > step ? cutoff - step : 1, std::min<std::size_t>(cutoff + step, 256)}) {
            if (error(from) < error(best)) {
                best = from;
            }
        }
    }
    return best;
}

} // namespace

void keepCoverage(const ImageRgba8& picture, float cutoff, std::span<ImageRgba8> levels) {
    const auto first = static_cast<std::size_t>(std::max(std::ceil(cutoff * 255.0f), 1.0f)); // that is kept
    const double wanted = static_cast<double>(samplesFrom(picture)[first]) /
                          static_cast<double>(kSamples * std::max<std::size_t>(picture.pixels.size(), 1));
    for (ImageRgba8& level : levels) {
        const std::size_t from = keptFrom(level, wanted, first);
        if (from == first) {
            continue;
        }
        // From half a step below: bytes are rounded, and none of them must cross the cutoff by that.
        const double scale = (static_cast<double>(first) - 0.5) / (static_cast<double>(from) - 0.5);
        for (Rgba8& pixel : level.pixels) {
            pixel[3] = static_cast<std::uint8_t>(std::min(std::lround(pixel[3] * scale), 255L));
        }
    }
}

} // namespace cdr::image
