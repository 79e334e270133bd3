#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/layered_truth.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace cdr::render_test {

/// The largest difference of a channel, in 8-bit steps.
inline int largestStep(const image::Rgba8& a, const image::Rgba8& b) {
    int largest = 0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        largest = std::max(largest, std::abs(int{a[c]} - int{b[c]}));
    }
    return largest;
}

/// The same of two pictures of one size.
inline int largestStep(const image::ImageRgba8& a, const image::ImageRgba8& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        largest = std::max(largest, largestStep(a.pixels[i], b.pixels[i]));
    }
    return largest;
}

/// The same to the truth, inside of surfaces and of background.
inline int largestStepTo(const measure::LayeredTruth& truth, const measure::TruthFinish& finish,
                         const image::ImageRgba8& picture) {
    const image::ImageRgba8 wanted = pictureOf(truth, finish);
    int largest = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        if (truth.pixels[i].isInner) {
            largest = std::max(largest, largestStep(wanted.pixels[i], picture.pixels[i]));
        }
    }
    return largest;
}

} // namespace cdr::render_test
