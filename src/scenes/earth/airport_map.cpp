#include <scenes/earth/airport_map.h>

#include <algorithm>
#include <cmath>

namespace cdr::scenes {

AirportMap::AirportMap(const Geodetic& centre) {
    const SineCosine longitude(centre.longitude);
    m_up = outward(SineCosine(centre.latitude), longitude);
    m_east = {-longitude.sine, longitude.cosine, 0.0};
    m_south = glm::cross(m_east, m_up);
}

glm::dvec2 AirportMap::at(const SineCosine& latitude, const SineCosine& longitude) const {
    const glm::dvec3 place = outward(latitude, longitude);
    // The place on the other side of the Earth has no direction.
    const double scale = kEarthRadius * std::sqrt(2.0 / std::max(1.0 + glm::dot(m_up, place), 1e-9));
    return scale * glm::dvec2(glm::dot(m_east, place), glm::dot(m_south, place));
}

} // namespace cdr::scenes
