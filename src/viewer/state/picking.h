#pragma once

#include <cdr/base/quantity_text.h>
#include <cdr/depth/technique.h>
#include <cdr/render/frame.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

/// What is under a pixel, in float64.
struct PickedPoint {
    std::uint32_t object = 0;  ///< index
    std::string name;          ///< the scene's, or "object 12"
    glm::dvec3 position{0.0};  ///< world space
    glm::dvec3 normal{0.0};    ///< world space, unit
    double distance = 0.0;     ///< from the camera, straight
    double distanceView = 0.0; ///< along the view axis
    double stepView = 0.0;     ///< what the technique tells apart there (techniqueStepView())
    double footprint = 0.0;    ///< what a pixel covers there, across the picture
};

/// Empty for background and outside the picture.
std::optional<PickedPoint> pickAt(const render::Frame& frame, const scene::Scene& scene,
                                  const depth::Technique& technique, std::uint32_t x, std::uint32_t y);

/// View distance under a pixel. If that is background or outside, it is that of the nearest surface among some
/// thousand pixels of the picture, or among all if these are background. Infinity if nothing is in view. A flight's speed
/// follows from it.
double surfaceView(const render::Frame& frame, const glm::dvec2& pixel);

/// Object index's name in the scene, or "object INDEX".
std::string objectName(const scene::Scene& scene, std::uint32_t object);

/// The materials of an object's parts, ascending. Takes time by the number of instances.
std::vector<std::uint32_t> materialsOf(const scene::Scene& scene, std::uint32_t object);

/// The way from one picked point to another.
struct Span {
    glm::dvec3 vector{0.0};   ///< world space, from the first to the second
    double length = 0.0;      ///< straight
    double alongView = 0.0;   ///< difference of the view distances, the second farther positive
    double uncertainty = 0.0; ///< half a pixel and a step at both ends, taken together
};
Span spanBetween(const PickedPoint& first, const PickedPoint& second);

/// Measuring by clicks: the first sets one end, the second the other, the third begins again.
class Measuring {
  public:
    void click(const PickedPoint& point);
    void clear() { m_first.reset(), m_second.reset(); }
    /// The materials of what was clicked on last; none where the scene has no such object.
    std::vector<std::uint32_t> materialsIn(const scene::Scene& scene) const;

    const std::optional<PickedPoint>& first() const { return m_first; }
    const std::optional<PickedPoint>& second() const { return m_second; }
    /// That was clicked on.
    const std::optional<PickedPoint>& last() const { return m_second ? m_second : m_first; }
    std::optional<Span> span() const;

  private:
    std::optional<PickedPoint> m_first;
    std::optional<PickedPoint> m_second;
};

/// "cube 12, 420 km away, a step of 2.439 µm", one line.
std::string describe(const PickedPoint& point, base::LengthUnit unit);
/// "5 mm, 4.98 mm of it along the view, to within 0.02 mm", one line.
std::string describe(const Span& span, base::LengthUnit unit);

} // namespace cdr::viewer
