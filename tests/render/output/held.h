#pragma once

#include <cdr/measure/truth/truth.h>
#include <cdr/render/frame.h>

#include <cstdint>

namespace cdr::render_test {

/// What a frame holds of each pixel, as the truth has it.
inline measure::TruthImage heldBy(const render::Frame& frame) {
    measure::TruthImage held(frame.width(), frame.height());
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 0; x < frame.width(); ++x) {
            held.at(x, y) = {.id = frame.id(x, y), .distanceView = frame.distanceView(x, y)};
        }
    }
    return held;
}

} // namespace cdr::render_test
