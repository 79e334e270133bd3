#include "picture_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace cdr::test {

namespace {

int difference(const image::Rgba8& a, const image::Rgba8& b) {
    int largest = 0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        largest = std::max(largest, std::abs(int{a[c]} - int{b[c]}));
    }
    return largest;
}

} // namespace

Comparison compare(const image::ImageRgba8& golden, const image::ImageRgba8& render,
                   const Tolerance& tolerance) {
    Comparison comparison{.sameSize = golden.width == render.width && golden.height == render.height,
                          .pixels = golden.pixels.size()};
    if (!comparison.sameSize || golden.pixels.empty()) {
        return comparison;
    }
    for (std::size_t i = 0; i < golden.pixels.size(); ++i) {
        const int here = difference(golden.pixels[i], render.pixels[i]);
        comparison.largest = std::max(comparison.largest, here);
        comparison.beyond += here > tolerance.channel ? 1 : 0;
    }
    comparison.passes = static_cast<double>(comparison.beyond) <=
                        tolerance.pixelShare * static_cast<double>(comparison.pixels);
    return comparison;
}

std::string describe(const Comparison& comparison) {
    if (!comparison.sameSize) {
        return "the sizes differ";
    }
    return fmt::format("{} of {} pixels beyond the tolerance, the largest difference is {} of 255",
                       comparison.beyond, comparison.pixels, comparison.largest);
}

} // namespace cdr::test
