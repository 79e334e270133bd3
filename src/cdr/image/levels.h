#pragma once

/// @file
/// @errors None.

#include <cdr/base/export.h>
#include <cdr/image/image.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::platform {
class WorkerPool;
}

namespace cdr::image {

/// What the red, green and blue of a picture are; alpha is a share in either case.
enum class Encoding : std::uint8_t { srgb, linear };

/// A side of the next smaller level: half, rounded down, but at least 1.
CDR_EXPORT std::uint32_t halvedSide(std::uint32_t side);

/// How many levels a picture has, itself included, down to one pixel: 0 for one without pixels.
CDR_EXPORT std::uint32_t levelCount(std::uint32_t width, std::uint32_t height);

/// The pixels of a picture's first `levels` levels together.
CDR_EXPORT std::uint64_t levelPixels(std::uint32_t width, std::uint32_t height, std::uint32_t levels);

/// How the smaller levels of a picture are made.
struct LevelRules {
    Encoding encoding = Encoding::srgb; ///< of red, green and blue
    bool alphaWeighs = false; ///< colours count by their alpha: what is clear does not show at edges
    /// In (0, 1], else ignored: texels whose alpha is below it are cut away. Each level's alpha is multiplied by a number,
    /// so that about the same share of it is kept as of the picture itself.
    std::optional<float> cutoff{};
};

/// The smaller levels of a picture, largest first, the picture itself left out. Each pixel is the average, in linear
/// light, of what it covers of the level above it. Where a side is odd, pixels count by the share that is covered.
/// Averages are rounded once for each level and not summed up.
/// @param most how many to make; fewer where one pixel is reached before.
/// @param workers make them, in bands of rows; null: the calling thread. The levels are the same to the bit.
CDR_EXPORT std::vector<ImageRgba8> smallerLevels(const ImageRgba8& picture, const LevelRules& rules,
                                                 std::uint32_t most, platform::WorkerPool* workers = nullptr);

/// The same with the rules of opaque pictures.
inline std::vector<ImageRgba8> smallerLevels(const ImageRgba8& picture, Encoding encoding,
                                             std::uint32_t most) {
    return smallerLevels(picture, LevelRules{.encoding = encoding}, most);
}

/// Whether several workers make a picture's levels in less time than one.
CDR_EXPORT bool areLevelsDivided(std::uint32_t width, std::uint32_t height);

} // namespace cdr::image
