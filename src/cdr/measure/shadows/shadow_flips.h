#pragma once

#include <cdr/measure/compare/flips.h>
#include <cdr/measure/shadows/wrong_shadows.h>

namespace cdr::measure {

/// A light's rendered shadows in a frame, and what they should be.
struct ShadowFrame {
    RenderedLight light;
    const ShadowImage& truth;
};

/// How a light's shadows flicker from one frame to the next. A pixel is compared where it is inner in both frames
/// (WrongShadows), and shows the same object, lit or shadowed alike, in both truths. It flips if the rendered light reaches
/// it in one frame only; so in one of them it is wrong. base::InputError when the sizes differ.
FlipCount countShadowFlips(const ShadowFrame& before, const ShadowFrame& after);

} // namespace cdr::measure
