#include <scenes/degree.h>
#include <scenes/orbit/airport.h>
#include <scenes/orbit/eclipse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cdr::scenes {

namespace {

/// Of the middle of the Moon's shadow on the ground, metres east of the airport: its rim is seen from the station.
constexpr double kShadowEast = 3.4e6;

/// A place that the path looks at, while the camera moves `by` on its way to the next.
struct Stop {
    glm::dvec3 eye{0.0};
    glm::dvec3 target{0.0};
    glm::dvec3 by{0.0};
    double degrees = 60.0;
};

/// On the ground to the east of the airport.
glm::dvec3 shadowedPlace(const EarthSurface& surface) {
    const double metresPerDegree = kEarthRadius * kDegree * std::cos(kOrbitAirport.latitude * kDegree);
    return surface.toWorld({kOrbitAirport.latitude, kOrbitAirport.longitude + kShadowEast / metresPerDegree},
                           0.0);
}

/// Moves the Moon to between the Sun and a place.
void moveMoon(scene::Scene& scene, const glm::dvec3& place) {
    const auto name = std::find(scene.objectNames.begin(), scene.objectNames.end(), "moon");
    const auto moon = static_cast<std::uint32_t>(name - scene.objectNames.begin());
    glm::dvec3 centre(0.0);
    double pieces = 0.0;
    scene::Instances& instances = scene.instances;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances.object[i] == moon) {
            centre += instances.position(i);
            pieces += 1.0;
        }
    }
    centre /= pieces;
    const glm::dvec3 toSun = glm::normalize(scene.lights.front().position - place);
    const glm::dvec3 by = place + kMoonDistance * toSun - centre;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances.object[i] == moon) {
            scene::placeInstance(scene, i, instances.position(i) + by, instances.basis[i]);
        }
    }
}

std::array<Stop, 4> eclipseStops(const StationPose& station, const EarthSurface& surface,
                                 const glm::dvec3& shadowed) {
    const glm::dvec3 right = glm::normalize(glm::cross(station.forward, station.up));
    const glm::dvec3 earth = surface.earthCentre();
    const glm::dvec3 hangars(180.0, 9.0, -300.0);
    const double tilt = kWindowTilt * kDegree;
    const glm::dvec3 ahead = std::cos(tilt) * station.forward - std::sin(tilt) * station.up;
    const glm::dvec3 along = glm::cross(right, ahead);
    // Of the frame's left beam, where bolts are.
    const glm::dvec3 frame =
        station.eye + kWindowDistance * (ahead - std::tan(41.0 * kDegree) * right) - 0.02 * right;
    const glm::dvec3 afar = glm::normalize(shadowed - earth + 0.3 * (station.eye - earth));
    return {{{.eye = frame - 0.15 * ahead - 0.12 * right - 0.05 * along,
              .target = frame,
              .by = 0.02 * along,
              .degrees = 40.0},
             {.eye = station.eye, .target = hangars, .by = 0.1 * right, .degrees = 0.06},
             {.eye = station.eye + 60.0 * station.forward,
              .target = shadowed,
              .by = 100.0 * right,
              .degrees = 60.0},
             {.eye = earth + 60e6 * afar, .target = earth, .by = 2e5 * right, .degrees = 16.0}}};
}

} // namespace

scene::SceneSetup makeEclipse(EarthMaps maps) {
    const EarthSurface surface(maps.topography, kOrbitAirport, airportPad());
    const StationPose station = orbitStation(surface);
    const glm::dvec3 shadowed = shadowedPlace(surface);
    const std::array<Stop, 4> stops = eclipseStops(station, surface, shadowed);
    scene::SceneSetup setup = makeOrbit(std::move(maps));
    setup.scene.name = "eclipse";
    setup.scene.lights.resize(1); // the Sun
    moveMoon(setup.scene, shadowed);
    const scene::Camera first = setup.path.at(0);
    setup.path = {.frames = kEclipseStopFrames * static_cast<std::uint32_t>(stops.size()),
                  .at = [stops, first](std::uint32_t frame) {
                      const Stop& stop = stops[frame / kEclipseStopFrames % stops.size()];
                      const double share =
                          static_cast<double>(frame % kEclipseStopFrames) / kEclipseStopFrames;
                      scene::Camera lens = first;
                      lens.fovY = stop.degrees * kDegree;
                      lens.nearView = 0.01;
                      return scene::lookAt(lens, stop.eye + share * stop.by, stop.target);
                  }};
    return setup;
}

scene::SceneSetup openEclipse(const OrbitFiles& files) {
    return makeEclipse(loadEarthMaps(files.folder));
}

} // namespace cdr::scenes
