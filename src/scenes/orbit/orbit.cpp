#include <scenes/degree.h>
#include <scenes/orbit/airport.h>
#include <scenes/orbit/orbit.h>
#include <scenes/solids.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace cdr::scenes {

namespace {

constexpr double kSunDistance = 149.6e9;
constexpr double kFarView = 4.5e8; ///< beyond the Moon
/// Below level, degrees: the first aim has horizon and Earth in the picture, the Moon stands over the
/// horizon.
constexpr double kFirstAim = 36.0;
constexpr double kMoonBelow = 18.4;
constexpr double kMoonRight = 9.0;
constexpr double kWidestDegrees = 60.0; ///< vertical field of view, of the path's first frame
constexpr double kNarrowestDegrees = 0.002;
constexpr std::uint32_t kZoomFrames = 240;
/// The aim's share of its way, to the power that the lens has: beyond 1 it comes closer than the lens.
constexpr double kAimPower = 1.5;

std::uint32_t addBlueMarble(SceneBuilder& builder, image::ImageRgba8 color) {
    const std::uint32_t texture = builder.addTexture(
        {.name = "blue marble", .pixels = std::move(color), .wrapV = scene::WrapMode::clampToEdge});
    return builder.addMaterial(scene::Material{.name = "earth", .baseColorTexture = texture});
}

void addEarth(SceneBuilder& builder, const EarthSurface& surface, const StationPose& station,
              const GroundCover& cover) {
    const std::function<TileCoat(const EarthTile&)> coatOf = cover(builder);
    builder.beginObject("earth");
    const EarthQuadtree tree = refineEarth(surface, orbitDetail(station));
    for (const EarthTile& leaf : tree.leaves()) {
        const TileCoat coat = coatOf(leaf);
        builder.addMesh(coat.material, tileMesh(surface, tree, leaf, coat.frame));
    }
}

/// Over the horizon, a little to the right.
void addMoon(SceneBuilder& builder, const EarthSurface& surface, const StationPose& station) {
    const glm::dvec3 right = glm::cross(station.forward, station.up);
    const glm::dvec3 level =
        std::cos(kMoonRight * kDegree) * station.forward + std::sin(kMoonRight * kDegree) * right;
    const glm::dvec3 towards =
        std::cos(kMoonBelow * kDegree) * level - std::sin(kMoonBelow * kDegree) * station.up;
    const glm::dvec3 fromCentre = station.eye - surface.earthCentre();
    // Along the ray from the eye, as far as makes its distance from the Earth's centre right.
    const double half = glm::dot(fromCentre, towards);
    const double along =
        -half + std::sqrt(half * half - glm::dot(fromCentre, fromCentre) + kMoonDistance * kMoonDistance);
    const std::uint32_t material = builder.addMaterial("moon", glm::vec3(0.35f, 0.34f, 0.33f));
    builder.beginObject("moon");
    glm::dmat4 place(1.0);
    place[3] = glm::dvec4(station.eye + along * towards, 1.0);
    builder.addMesh(material, sphereMesh("moon", kMoonRadius, 64), place);
}

void addLights(scene::Scene& scene, const StationPose& station) {
    scene.lights.push_back({.position = kSunDistance * orbitToSun(),
                            .color = glm::vec3(1.5f),
                            .halfDistance = 100.0 * kSunDistance});
    // A lamp in the cabin, which reaches no further than the window.
    scene.lights.push_back({.position = station.eye + 0.15 * station.up,
                            .color = glm::vec3(0.5f, 0.45f, 0.38f),
                            .halfDistance = 0.2});
    scene.ambient = glm::vec3(0.04f);
    scene.background = glm::vec3(0.0f);
}

/// The unit vector `share` of the angle on from `a` to `b`, both unit.
glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double share) {
    const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    if (angle < 1e-9) {
        return b;
    }
    return (std::sin((1.0 - share) * angle) * a + std::sin(share * angle) * b) / std::sin(angle);
}

/// A look through the station's window that ends as one through a telescope. The lens narrows by the same factor every
/// frame. The aim nears the target faster than the lens narrows, so the target comes into the picture and stays there.
/// Frames beyond the path begin it again.
scene::CameraPath zoomPath(const StationPose& station) {
    const double below = kFirstAim * kDegree;
    const glm::dvec3 firstAim = std::cos(below) * station.forward - std::sin(below) * station.up;
    const glm::dvec3 target(0.0, kSlabHeight + kMarkingHeight, 0.0);
    return {.frames = kZoomFrames, .at = [eye = station.eye, firstAim, target](std::uint32_t frame) {
                const double share = (frame % kZoomFrames) / (kZoomFrames - 1.0);
                const double degrees = kWidestDegrees * std::pow(kNarrowestDegrees / kWidestDegrees, share);
                const double away =
                    std::max(0.0, (degrees - kNarrowestDegrees) / (kWidestDegrees - kNarrowestDegrees));
                const glm::dvec3 lastAim = glm::normalize(target - eye);
                const glm::dvec3 aim = between(lastAim, firstAim, std::pow(away, kAimPower));
                const scene::Camera lens{
                    .fovY = degrees * std::numbers::pi / 180.0, .nearView = 0.1, .farView = kFarView};
                return scene::lookAt(lens, eye, eye + glm::distance(eye, target) * aim);
            }};
}

} // namespace

glm::dvec3 orbitToSun() {
    return glm::normalize(glm::dvec3(-0.35, 0.75, 0.55));
}

StationPose orbitStation(const EarthSurface& surface) {
    const double metresPerDegree = kEarthRadius * kDegree * std::cos(kOrbitAirport.latitude * kDegree);
    const Geodetic below{kOrbitAirport.latitude, kOrbitAirport.longitude - kStationWest / metresPerDegree};
    StationPose pose;
    pose.eye = surface.toWorld(below, kStationHeight);
    pose.up = glm::normalize(pose.eye - surface.toWorld(below, 0.0));
    // Level, towards the airport, which is the origin.
    pose.forward = glm::normalize(-pose.eye + glm::dot(pose.eye, pose.up) * pose.up);
    return pose;
}

TileDetail orbitDetail(const StationPose& station) {
    return {.eye = station.eye, .place = {airportPad().centre.x, 0.0, airportPad().centre.y}};
}

scene::SceneSetup makeOrbit(EarthMaps maps, const scene::Scene* parked) {
    const EarthSurface surface(maps.topography, kOrbitAirport, airportPad());
    const auto cover = [&](SceneBuilder& builder) {
        const std::uint32_t material = addBlueMarble(builder, std::move(maps.color));
        return [material](const EarthTile&) { return TileCoat{material}; };
    };
    return makeOrbitOn(surface, cover, parked);
}

scene::SceneSetup makeOrbitOn(const EarthSurface& surface, const GroundCover& cover,
                              const scene::Scene* parked) {
    const StationPose station = orbitStation(surface);
    scene::SceneSetup setup;
    setup.scene.name = "orbit";
    SceneBuilder builder(setup.scene);
    // Nearest first, as an engine that sorts for early depth tests submits them. So a depth buffer that does not
    // resolve paint, slab and soil shows soil.
    addStation(builder, station);
    if (parked != nullptr) {
        addParkedModel(builder, *parked);
    } else {
        addAircraft(builder);
    }
    addAirport(builder);
    addEarth(builder, surface, station, cover);
    addMoon(builder, surface, station);
    addLights(setup.scene, station);
    setup.path = zoomPath(station);
    return setup;
}

scene::OpenedScene openOrbit(const OrbitFiles& files) {
    if (files.model.empty()) {
        return {.setup = makeOrbit(loadEarthMaps(files.folder)), .notes = {}};
    }
    scene::GltfImport model = scene::loadGltf(files.model, files.limits);
    return {.setup = makeOrbit(loadEarthMaps(files.folder), &model.scene), .notes = std::move(model.ignored)};
}

} // namespace cdr::scenes
