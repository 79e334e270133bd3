#pragma once

#include <cdr/image/image.h>
#include <cdr/platform/worker_pool.h>
#include <scenes/earth/airport_map.h>
#include <scenes/earth/blue_marble.h>
#include <scenes/earth/clouds.h>
#include <scenes/earth/countryside.h>
#include <scenes/orbit/earth_tiles.h>

#include <optional>

namespace cdr::scenes {

/// Paints the Earth from above: the blue marble, with coasts, country and clouds where it is too coarse. Each place has one colour,
/// whichever picture it is on, except for what the picture's texels are too large to show.
class GroundPainter {
  public:
    /// @param marble plate carree; must outlive the painter.
    /// @param toShade as of Clouds.
    GroundPainter(const image::ImageRgba8& marble, const Geodetic& airport, const glm::dvec2& toShade);

    /// What is painted, on how many texels: multiples of kGridTexels.
    struct Canvas {
        GeodeticFrame frame{};
        std::uint32_t width = 0;
        std::uint32_t height = 0;
        /// What another picture shows more finely: only a few of its texels are worked out, for levels of less detail.
        std::optional<GeodeticFrame> hidden{};
        /// Where details are as fine as texels. From there to the edge they grow to `growth` times the size, as a coarser
        /// picture around this one has them. So no line is seen between the two. Without it all are fine.
        std::optional<GeodeticFrame> fine{};
        double growth = 2.0; ///< at least 1
    };
    image::ImageRgba8 paint(const Canvas& canvas, platform::WorkerPool& workers) const;

  private:
    /// What a coarse grid holds.
    struct Slow {
        MarbleColor marble;
        Country country;
        Clouds::Weather weather;
    };
    Slow slowAt(const Geodetic& place, const Fineness& fineness) const;
    static Slow between(const Slow& a, const Slow& b, double share);
    glm::dvec3 colorOf(const Slow& slow, const glm::dvec2& place, const Fineness& fineness) const;

    BlueMarble m_marble;
    AirportMap m_map;
    Clouds m_clouds;
};

} // namespace cdr::scenes
