#pragma once

#include <cdr/measure/compare/share.h>
#include <cdr/measure/shadows/shadow_truth.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace cdr::measure {

/// How a light's rendered shadows compare with the truth.
///
/// Pixels whose surface faces the light count. An inner one is alike in object and reach with its eight neighbours; edges
/// are decided by the texels of maps.
struct WrongShadows {
    std::uint64_t pixels = 0;    ///< inner pixels
    std::uint64_t shadowed = 0;  ///< inner pixels that are shadowed in truth
    std::uint64_t wrong = 0;     ///< inner pixels that are lit in the picture or in truth, not in both
    std::uint64_t edgeWrong = 0; ///< all others

    /// Share of the inner pixels; none where there are none to judge by.
    std::optional<double> fraction() const { return shareOf(wrong, pixels); }
    WrongShadows& operator+=(const WrongShadows& other);
};

/// Where a light arrives in a rendered picture.
struct RenderedLight {
    const image::ImageRgba8& reached; ///< a channel for each light: not 0 where it reaches the surface
    std::size_t channel = 0;          ///< of the light, 0 to 3

    bool reaches(std::uint32_t x, std::uint32_t y) const { return reached.at(x, y)[channel] != 0; }
};

/// Whether a pixel of the picture is an inner one: its surface faces the light, its eight neighbours are alike, and no filter
/// of a mask's texture decides.
bool isInnerShadow(const ShadowImage& truth, std::uint32_t x, std::uint32_t y);

/// base::InputError when the sizes differ.
WrongShadows countWrongShadows(const RenderedLight& light, const ShadowImage& truth);

/// Red where a shadow is missing off edges, blue where one is that should not be, orange where either is at an edge.
/// Elsewhere it is the picture as grey at half its brightness. base::InputError when the sizes differ.
image::ImageRgba8 shadowHeatMap(const RenderedLight& light, const ShadowImage& truth,
                                const image::ImageRgba8& picture);

} // namespace cdr::measure
