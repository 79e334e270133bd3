#pragma once

#include <cdr/image/codec.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/frame.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::output {

/// What a frame can be written as.
enum class Aov : std::uint8_t {
    color, ///< the shaded picture, sRGB
    linear, ///< its light before exposure, tone mapping and antialiasing, as it is in EXR; in 8 bits cut off at 1
    id,     ///< object index + 1 as R + 256 G + 65536 B, background 0
    distance, ///< view distance: exact in EXR; in 8 bits its logarithm, near white to far dark
    normal,   ///< view space, (n + 1) / 2
    cascade,  ///< one tint per cascade, times the picture's lightness
    wrong,    ///< red where wrong off edges, orange on edges
    coverage, ///< translucent surfaces in front of the opaque one: counts in EXR; in 8 bits grey, 16 a
              ///< surface
};

std::string_view nameOf(Aov aov);
/// base::InputError with a suggestion for an unknown name.
Aov parseAov(std::string_view name);

/// The colour in which Aov::cascade shows a cascade's surface of that lightness, the largest of its channels.
image::Rgba8 cascadeTint(std::size_t cascade, std::uint8_t light);

/// The 8-bit picture of an output. `truth` is needed for Aov::wrong alone.
image::ImageRgba8 pictureOf(const render::Frame& frame, Aov aov, const measure::TruthImage* truth);

/// The float channels of an output, for EXR: R G B of the picture for color and wrong, of light for linear, else the values
/// themselves. Distance has three. `distance` is float32, and `distanceRest` is the rest of the float64, so the
/// sum of both is exact to the anchored step. `ahead` is as the G-buffer holds it.
std::vector<image::ExrChannel> channelsOf(const render::Frame& frame, Aov aov,
                                          const measure::TruthImage* truth);

/// SHA-256 of an output's values: RGBA bytes of color and wrong, floats of linear, else 32-bit values as the G-buffer holds
/// them.
std::string hashOf(const render::Frame& frame, Aov aov, const measure::TruthImage* truth);

/// One SHA-256 over the whole G-buffer and the picture.
std::string hashOf(const render::Frame& frame);

} // namespace cdr::output
