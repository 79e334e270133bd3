#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/compare/share.h>
#include <cdr/render/frame.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

/// How many pixels of a frame show another object than the anchored answer.
struct WrongCount {
    std::uint64_t inner = 0;     ///< pixels whose answer is shared by all eight neighbours
    std::uint64_t wrong = 0;     ///< of those
    std::uint64_t edgeWrong = 0; ///< elsewhere, where rasterisation decides
    std::size_t objects = 0;     ///< in view: none, one, or 2 for more; of one, no pixel can show another

    /// Wrong pixels of the inner ones; none where there are none to judge by.
    std::optional<double> share() const { return measure::shareOf(wrong, inner); }
};

/// measure::heatMap() with the anchored answer in place of the truth. Red where wrong off edges, orange on
/// edges, else the picture in dim grey. base::InputError when the sizes differ.
/// @param reference the same camera's frame by referenceTechnique().
WrongCount paintWrong(const render::Frame& frame, const render::Frame& reference, image::ImageRgba8& picture);

/// The count alone.
WrongCount countWrong(const render::Frame& frame, const render::Frame& reference);

/// "wrong 23.0 % | 0 %", a share for each side, "-" without inner pixels, or that there is one object. Empty without
/// counts and where nothing is in view.
std::string wrongText(const std::vector<WrongCount>& sides);

/// "23.0 %": a share of 1 in three significant digits.
std::string shareText(double share);

} // namespace cdr::viewer
