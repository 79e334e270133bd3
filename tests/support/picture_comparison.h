#pragma once

#include <cdr/image/image.h>

#include <cstdint>
#include <string>

namespace cdr::test {

/// How much a picture may differ from another and still pass.
struct Tolerance {
    int channel = 5;           ///< of 255, in either direction, in each of red, green, blue and alpha
    double pixelShare = 0.001; ///< of the pixels that may differ by more
};

/// How two pictures differ.
struct Comparison {
    bool sameSize = false;
    std::uint64_t pixels = 0;
    std::uint64_t beyond = 0; ///< pixels with a channel beyond the tolerance
    int largest = 0;          ///< difference of any channel, absolute
    bool passes = false;
};

/// Compares every channel of every pixel. Pictures of different sizes, or without pixels, never pass.
Comparison compare(const image::ImageRgba8& golden, const image::ImageRgba8& render,
                   const Tolerance& tolerance = {});

/// The comparison in one line.
std::string describe(const Comparison& comparison);

} // namespace cdr::test
