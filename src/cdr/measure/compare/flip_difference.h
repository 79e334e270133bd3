#pragma once

#include <cdr/image/image.h>
#include <cdr/platform/worker_pool.h>

#include <array>
#include <cstdint>
#include <vector>

namespace cdr::measure {

/// How a picture is looked at: what a pixel subtends.
struct Viewing {
    /// The paper's own: a 3840 pixel wide screen of 0.7 m seen from 0.7 m, 67.02.
    double pixelsPerDegree = 0.7 * 3840.0 / 0.7 * 3.14159265358979323846 / 180.0;
};

/// LDR-FLIP: how strongly a viewer who switches between two pictures sees them differ, per pixel, from 0 (not
/// at all) to 1. After Andersson et al., "FLIP - A Difference Evaluator for Alternating Images", HPG 2020. Not to
/// be confused with the flips of flips.h.
///
/// Colours are filtered by the eye's contrast sensitivity, and compared in Hunt-adjusted L*a*b* by HyAB. The
/// difference is raised where edges or points appear or vanish. Borders repeat the outermost pixels. Alpha is
/// not looked at. Arithmetic is float32, within 10^-5 of the float64 reference of the tests.
class FlipDifference {
  public:
    /// base::InputError unless a degree spans between 1 and 1000 pixels.
    explicit FlipDifference(const Viewing& viewing = {});

    /// The difference of every pixel, the same bits for any number of workers. Pixels that have no differing
    /// pixel within reach() of them cost next to nothing. base::InputError when the sizes differ.
    image::ImageFloat map(const image::ImageRgba8& reference, const image::ImageRgba8& test,
                          platform::WorkerPool& workers) const;

    /// The mean of map(), 0 for a picture without pixels.
    double mean(const image::ImageRgba8& reference, const image::ImageRgba8& test,
                platform::WorkerPool& workers) const;

    /// How far, in pixels along rows and columns, a pixel's difference depends on others.
    std::uint32_t reach() const { return m_reach; }

    /// Taps of a filter from -reach() to reach().
    using Taps = std::vector<float>;

  private:
    class Tile;
    struct Filters {
        Taps lightness;                 ///< contrast sensitivity, achromatic
        Taps redGreen;                  ///< contrast sensitivity, red-green
        std::array<Taps, 2> blueYellow; ///< contrast sensitivity, blue-yellow: a sum of two
        std::array<float, 2> blueYellowShares{};
        Taps smooth; ///< Gaussian that features are found with
        Taps edge;   ///< its first derivative
        Taps point;  ///< its second derivative
    };

    std::uint32_t m_reach;
    Filters m_filters;
};

} // namespace cdr::measure
