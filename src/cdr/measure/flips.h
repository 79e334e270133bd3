#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth.h>

#include <cstdint>

namespace cdr::measure {

/// What was rendered in one frame and what should have been.
struct IdFrame {
    image::ImageU32 ids;
    TruthImage truth;
};

/// Pixels that flicker from one frame to the next: inner in both frames, the same object in truth, yet drawn
/// as different objects, so at least one of the two is wrong. A wrong pixel that stays put does not flip.
/// base::InputError when the sizes differ.
std::uint64_t countFlips(const IdFrame& before, const IdFrame& after);

} // namespace cdr::measure
