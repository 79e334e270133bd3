#include <scenes/orbit/data.h>
#include <scenes/orbit/earth_surface.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cdr::scenes {

namespace {

// WGS84.
constexpr double kEquatorRadius = 6'378'137.0;
constexpr double kEccentricitySquared = kEarthFlattening * (2.0 - kEarthFlattening);

/// Degrees within which normals are taken: 2 km, an eighth of a texel of the topography.
constexpr double kNormalStep = 0.02;
/// Degrees of latitude beyond which normals are the ellipsoid's.
constexpr double kPolar = 85.0;

glm::dvec3 outward(const Geodetic& place) {
    return outward(SineCosine(place.latitude), SineCosine(place.longitude));
}

/// About the Earth's centre.
glm::dvec3 onEllipsoid(const Geodetic& place, double height) {
    const glm::dvec3 up = outward(place);
    const double across = kEquatorRadius / std::sqrt(1.0 - kEccentricitySquared * up.z * up.z);
    return {(across + height) * up.x, (across + height) * up.y,
            (across * (1.0 - kEccentricitySquared) + height) * up.z};
}

/// Between neighbouring texels, whose centres lie half a texel in.
struct Texels {
    std::uint32_t first;
    std::uint32_t second;
    double share;
};

/// What lies beyond the ends of a row or a column of texels.
enum class Beyond : std::uint8_t { wraps, clamps };

Texels texelsAt(double share, std::uint32_t count, Beyond beyond) {
    const double position = share * count - 0.5;
    const double below = std::floor(position);
    const auto index = [&](double i) {
        const double n = count;
        const double inside =
            beyond == Beyond::wraps ? i - n * std::floor(i / n) : std::clamp(i, 0.0, n - 1.0);
        return std::min(static_cast<std::uint32_t>(inside), count - 1);
    };
    return {index(below), index(below + 1.0), position - below};
}

} // namespace

SineCosine::SineCosine(double degrees) {
    const double radians = (degrees == -180.0 ? 180.0 : degrees) * std::numbers::pi / 180.0;
    sine = std::sin(radians);
    cosine = std::abs(degrees) == 90.0 ? 0.0 : std::cos(radians);
}

glm::dvec3 outward(const SineCosine& latitude, const SineCosine& longitude) {
    return {latitude.cosine * longitude.cosine, latitude.cosine * longitude.sine, latitude.sine};
}

EarthSurface::EarthSurface(const image::ImageRgba8& topography, const Geodetic& origin, const Pad& pad)
    : m_topography(topography),
      m_pad(pad) {
    const SineCosine longitude(origin.longitude);
    m_up = outward(origin);
    m_east = {-longitude.sine, longitude.cosine, 0.0};
    m_south = glm::cross(m_east, m_up);
    m_origin = onEllipsoid(origin, topographyAt(origin));
}

double EarthSurface::topographyAt(const Geodetic& place) const {
    // A pole has one height, whatever the texels around it say.
    const double longitude = std::abs(place.latitude) == 90.0 ? 0.0 : place.longitude;
    const Texels x = texelsAt((longitude + 180.0) / 360.0, m_topography.width, Beyond::wraps);
    const Texels y = texelsAt((90.0 - place.latitude) / 180.0, m_topography.height, Beyond::clamps);
    const auto grey = [&](std::uint32_t i, std::uint32_t j) {
        return static_cast<double>(m_topography.at(i, j)[0]);
    };
    const double above = std::lerp(grey(x.first, y.first), grey(x.second, y.first), x.share);
    const double below = std::lerp(grey(x.first, y.second), grey(x.second, y.second), x.share);
    return kMetresPerGrey * std::lerp(above, below, y.share);
}

glm::dvec3 EarthSurface::toWorld(const Geodetic& place, double height) const {
    const glm::dvec3 d = onEllipsoid(place, height) - m_origin;
    return {glm::dot(m_east, d), glm::dot(m_up, d), glm::dot(m_south, d)};
}

glm::dvec3 EarthSurface::earthCentre() const {
    return {-glm::dot(m_east, m_origin), -glm::dot(m_up, m_origin), -glm::dot(m_south, m_origin)};
}

glm::dvec3 EarthSurface::at(const Geodetic& place) const {
    glm::dvec3 ground = toWorld(place, topographyAt(place));
    // What lies below the pad on the other side of the Earth is none of it.
    if (ground.y > -m_pad.radius) {
        const double beyond = glm::distance(glm::dvec2(ground.x, ground.z), m_pad.centre) / m_pad.radius;
        const double share = std::clamp(beyond - 1.0, 0.0, 1.0);
        ground.y *= share * share * (3.0 - 2.0 * share);
    }
    return ground;
}

glm::dvec3 EarthSurface::normalAt(const Geodetic& place) const {
    // Towards a pole texels shrink to needles, whose slopes mean nothing.
    if (std::abs(place.latitude) > kPolar) {
        const glm::dvec3 up = outward(place);
        return {glm::dot(m_east, up), glm::dot(m_up, up), glm::dot(m_south, up)};
    }
    const double step = kNormalStep / SineCosine(place.latitude).cosine;
    const glm::dvec3 east =
        at({place.latitude, place.longitude + step}) - at({place.latitude, place.longitude - step});
    const glm::dvec3 north = at({place.latitude + kNormalStep, place.longitude}) -
                             at({place.latitude - kNormalStep, place.longitude});
    return glm::normalize(glm::cross(east, north));
}

} // namespace cdr::scenes
