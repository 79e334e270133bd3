#pragma once

#include <cdr/base/export.h>
#include <cdr/depth/cascade.h>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// Depth of field by per-cascade resolution (thesis chapter 3): what is out of focus is drawn in fewer
/// pixels.
struct Focus {
    double distance = 0.0; ///< view distance that is sharp, scene units; 0 for everything
    double aperture = 0.0; ///< diameter of the lens, scene units
    /// Lets cascades overlap and fade into each other, which hides where they meet.
    bool blend = false;

    /// Whether anything is out of focus.
    /// @errors None.
    bool isOn() const { return distance > 0.0; }
    bool operator==(const Focus&) const = default;
};

/// Refuses a focus that cannot be drawn.
/// @throws base::InputError that names the value, unless both are finite and not negative.
CDR_EXPORT void requireUsable(const Focus& focus);

/// Fewest pixels of a cascade's own G-buffer: a sixteenth of the picture's along each side.
inline constexpr std::uint32_t kMaxFocusScale = 16;

/// A focused lens as a picture sees it.
/// @threads Any number at once: it does not change.
/// @errors None.
/// @units View distances in scene units; circles of confusion in pixels across.
class CDR_EXPORT FocusLens {
  public:
    /// @param focus that is on.
    /// @param tanY of half the vertical field of view; the picture is `height` pixels high.
    FocusLens(const Focus& focus, double tanY, std::uint32_t height);

    /// Diameter, in pixels, of the disc that a point at view distance w becomes. It is aperture |w - F| / w
    /// times the pixels that a scene unit covers at F. F is the distance in focus (thin lens, as in Potmesil
    /// and Chakravarty 1981).
    double circleAt(double distanceView) const;

    /// Pixels of the picture along the side of one pixel of a cascade's own G-buffer. It is the largest
    /// power of two up to kMaxFocusScale not above the smallest circle in the range. So nothing is blurred more than the
    /// lens would.
    std::uint32_t scaleOf(const depth::Cascade& range) const;

    /// The ranges to draw where cascades that touch are to fade into each other. Each but the first begins a
    /// fifth earlier, but no earlier than the cascade before it. Nor does it begin before the distance where
    /// the lens blurs half as much as the cascade's scale. Near planes still ascend.
    depth::Cascades overlapping(const depth::Cascades& cascades) const;

    /// Where to cut so that cascades waste no resolution: the distances whose circles are 2, 4, 8 and 16
    /// pixels, ascending.
    std::vector<double> boundaries() const;

  private:
    double m_distance;
    double m_circleAtInfinity;
};

} // namespace cdr::render
