#pragma once

#include <cdr/image/image.h>

#include <glm/glm.hpp>

namespace cdr::scenes {

/// A place on the Earth: geodetic, degrees, north and east positive.
struct Geodetic {
    double latitude = 0.0;
    double longitude = 0.0;
};

/// The sine and the cosine of an angle. Exact at the poles, where all longitudes must meet in one point, and the same from
/// both sides of 180 degrees.
struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;

    explicit SineCosine(double degrees);
};

/// The ellipsoid's unit normal, about the Earth's centre: x to 0 E, z to the north pole.
glm::dvec3 outward(const SineCosine& latitude, const SineCosine& longitude);

/// The ground in float64: the WGS84 ellipsoid plus a topography, levelled around one place.
///
/// World space has its origin at that place; x is east, y up, z south, in metres. So positions near the origin are
/// as fine as float64 allows (2^-34 m at 420 km). Coordinates about the Earth's centre would have steps of 10^-9 m
/// everywhere.
class EarthSurface {
  public:
    /// A disc of ground at y = 0 exactly, so that what is built on it lies as far above as it says. Beyond
    /// its radius it blends into the topography, which is as it was from twice the radius on.
    struct Pad {
        glm::dvec2 centre{0.0}; ///< world x and z, metres
        double radius = 0.0;    ///< metres
    };

    /// @param topography grey, kMetresPerGrey each; must outlive the surface.
    EarthSurface(const image::ImageRgba8& topography, const Geodetic& origin, const Pad& pad);

    /// The ground at a place, world space, metres.
    glm::dvec3 at(const Geodetic& place) const;
    /// Its unit normal, world space, from the heights 2 km around; within 5 degrees of a pole the
    /// ellipsoid's.
    glm::dvec3 normalAt(const Geodetic& place) const;

    /// The topography there in metres above the ellipsoid, without the pad.
    double topographyAt(const Geodetic& place) const;
    /// World space, of a height above the ellipsoid. The ground's own height does not matter.
    glm::dvec3 toWorld(const Geodetic& place, double height) const;
    glm::dvec3 earthCentre() const;

  private:
    const image::ImageRgba8& m_topography;
    Pad m_pad;
    glm::dvec3 m_origin{0.0}; ///< about the Earth's centre, as the axes: x to 0 E, z to the north pole
    glm::dvec3 m_east{0.0};
    glm::dvec3 m_up{0.0};
    glm::dvec3 m_south{0.0};
};

/// Of WGS84: 1 - polar radius / equatorial radius.
inline constexpr double kEarthFlattening = 1.0 / 298.257223563;

/// Mean radius of the Earth, metres.
inline constexpr double kEarthRadius = 6'371'008.8;

} // namespace cdr::scenes
