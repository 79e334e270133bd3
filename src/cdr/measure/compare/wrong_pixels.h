#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/compare/share.h>
#include <cdr/measure/truth/truth.h>

#include <cstdint>
#include <optional>

namespace cdr::measure {

/// How a rendered id image compares with the truth.
///
/// An inner pixel is one whose true id is an object's (not background) and is shared by its eight neighbours.
/// Pixels at the picture's border have no eight neighbours and are not inner. Nor are those whose truth is doubtful, because
/// the filter of a masked texture decides (TruthImage::doubtful). Elsewhere rasterisation rules decide, not depth.
struct WrongPixels {
    std::uint64_t pixels = 0;        ///< inner pixels
    std::uint64_t wrong = 0;         ///< inner pixels whose rendered id differs from the true id
    std::uint64_t edgeWrong = 0;     ///< all other pixels that differ
    std::uint64_t overlapPixels = 0; ///< inner pixels with a second object behind the first
    std::uint64_t overlapWrong = 0;  ///< those of them that are wrong

    /// Share of the inner pixels; none where there are none to judge by.
    std::optional<double> fraction() const { return shareOf(wrong, pixels); }
    /// Share of the inner pixels with a second object; none likewise.
    std::optional<double> overlapFraction() const { return shareOf(overlapWrong, overlapPixels); }
    WrongPixels& operator+=(const WrongPixels& other);
};

/// Per pixel: 1 where the truth is an object's, not doubtful, and its eight neighbours share the id, else 0.
image::Raster<std::uint8_t> innerMask(const TruthImage& truth);
/// The same of ids (object index + 1), for answers other than the truth, into a mask that is resized as
/// needed.
void innerMask(const image::ImageU32& ids, image::Raster<std::uint8_t>& mask);

/// Compares ids (object index + 1) of one size; base::InputError when the sizes differ.
WrongPixels countWrong(const image::ImageU32& ids, const TruthImage& truth);
/// The same with the truth's innerMask(), for callers that compare several ids with one truth.
WrongPixels countWrong(const image::ImageU32& ids, const TruthImage& truth,
                       const image::Raster<std::uint8_t>& inner);

/// Half as bright and without hue, so that only the marks have colour.
inline image::Rgba8 dimmed(const image::Rgba8& color) {
    // Rec. 709 luma in 1/512, which halves it.
    const unsigned luma = (109u * color[0] + 366u * color[1] + 37u * color[2]) / 1024u;
    const auto grey = static_cast<std::uint8_t>(luma);
    return {grey, grey, grey, 255};
}

/// The heat map, opaque. Pixels that are wrong are red (255, 0, 0) off edges and orange (255, 165, 0) on edges.
/// Others show the picture as grey at half its brightness. base::InputError when the sizes differ.
image::ImageRgba8 heatMap(const image::ImageU32& ids, const TruthImage& truth,
                          const image::ImageRgba8& picture);

} // namespace cdr::measure
