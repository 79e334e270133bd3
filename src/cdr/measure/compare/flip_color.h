#pragma once

#include <cdr/image/image.h>

namespace cdr::measure {

/// A colour in the linear opponent space that FLIP filters in: achromatic, red-green, blue-yellow.
struct Opponent {
    float y = 0.0f;
    float cx = 0.0f;
    float cz = 0.0f;
};

/// YCxCz of an 8-bit sRGB colour (Andersson et al. 2020, section 4.1), relative to its white.
Opponent opponentOf(const image::Rgba8& srgb);

/// A colour in L*a*b* whose a and b shrink with lightness as the Hunt effect has it (section 4.1).
struct HuntLab {
    float l = 0.0f;
    float a = 0.0f;
    float b = 0.0f;
};

/// From filtered opponents, clamped to what a screen can show.
HuntLab huntLabOf(const Opponent& color);

/// HyAB distance (Abasi et al. 2020): lightness by itself, chroma together.
float hyab(const HuntLab& a, const HuntLab& b);

/// The colour difference from 0 to 1: large ones compressed, green to blue being the largest (section 4.1.3).
float redistribute(float hyabDistance);

} // namespace cdr::measure
