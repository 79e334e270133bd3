#pragma once

/// @file
/// @errors None.

#include <cdr/base/export.h>
#include <cdr/image/image.h>

#include <cstdint>
#include <vector>

namespace cdr::image {

/// What the red, green and blue of a picture are; alpha is a share in either case.
enum class Encoding : std::uint8_t { srgb, linear };

/// A side of the next smaller level: half, rounded down, but at least 1.
CDR_EXPORT std::uint32_t halvedSide(std::uint32_t side);

/// How many levels a picture has, itself included, down to one pixel: 0 for one without pixels.
CDR_EXPORT std::uint32_t levelCount(std::uint32_t width, std::uint32_t height);

/// The pixels of a picture's first `levels` levels together.
CDR_EXPORT std::uint64_t levelPixels(std::uint32_t width, std::uint32_t height, std::uint32_t levels);

/// The smaller levels of a picture, largest first, the picture itself left out. Each pixel is the average, in linear
/// light, of what it covers of the level above it. Where a side is odd, pixels count by the share that is covered.
/// Averages are rounded once for each level and not summed up. Alpha does not weigh colours.
/// @param most how many to make; fewer where one pixel is reached before.
CDR_EXPORT std::vector<ImageRgba8> smallerLevels(const ImageRgba8& picture, Encoding encoding,
                                                 std::uint32_t most);

} // namespace cdr::image
