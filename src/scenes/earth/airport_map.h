#pragma once

#include <scenes/orbit/earth_surface.h>

#include <glm/glm.hpp>

namespace cdr::scenes {

/// The Earth as a plane with true areas, around a place (Lambert 1772): metres east and south of it. Near the place it is the
/// plane y = 0 of world space, to a thousandth.
class AirportMap {
  public:
    explicit AirportMap(const Geodetic& centre);

    glm::dvec2 at(const SineCosine& latitude, const SineCosine& longitude) const;
    glm::dvec2 at(const Geodetic& place) const {
        return at(SineCosine(place.latitude), SineCosine(place.longitude));
    }

  private:
    glm::dvec3 m_east;
    glm::dvec3 m_up;
    glm::dvec3 m_south;
};

} // namespace cdr::scenes
