#include <scenes/degree.h>
#include <scenes/earth/airport_map.h>

#include <algorithm>
#include <cmath>

namespace cdr::scenes {

namespace {

glm::dvec3 onUnitSphere(const SineCosine& latitude, const SineCosine& longitude) {
    return {latitude.cosine * longitude.cosine, latitude.cosine * longitude.sine, latitude.sine};
}

} // namespace

SineCosine::SineCosine(double degrees)
    : sine(std::sin(degrees * kDegree)),
      cosine(std::cos(degrees * kDegree)) {}

AirportMap::AirportMap(const Geodetic& centre) {
    const SineCosine longitude(centre.longitude);
    m_up = onUnitSphere(SineCosine(centre.latitude), longitude);
    m_east = {-longitude.sine, longitude.cosine, 0.0};
    m_south = glm::cross(m_east, m_up);
}

glm::dvec2 AirportMap::at(const SineCosine& latitude, const SineCosine& longitude) const {
    const glm::dvec3 place = onUnitSphere(latitude, longitude);
    // The place on the other side of the Earth has no direction.
    const double scale = kEarthRadius * std::sqrt(2.0 / std::max(1.0 + glm::dot(m_up, place), 1e-9));
    return scale * glm::dvec2(glm::dot(m_east, place), glm::dot(m_south, place));
}

} // namespace cdr::scenes
