#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/platform/worker_pool.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace cdr::render_test {

/// The truth with all its layers, cast by two threads.
inline measure::LayeredTruth layersOf(const scene::Scene& scene, const scene::Camera& camera,
                                      std::uint32_t width, std::uint32_t height) {
    platform::WorkerPool workers(2);
    return measure::castLayers(scene, camera, width, height, workers);
}

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

/// Of the pixels inside of surfaces and of background, how many are more than two steps off the truth.
struct OffTruth {
    std::size_t off = 0;
    std::size_t inner = 0;
};

inline OffTruth offTruth(const measure::LayeredTruth& truth, const image::ImageRgba8& picture) {
    const image::ImageRgba8 wanted = pictureOf(truth);
    OffTruth found;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        if (truth.pixels[i].isInner) {
            found.off += largestStep(wanted.pixels[i], picture.pixels[i]) > 2 ? 1 : 0;
            ++found.inner;
        }
    }
    return found;
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
