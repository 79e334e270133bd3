#pragma once

#include <cdr/scene/scene_setup.h>
#include <scenes/orbit/data.h>
#include <scenes/orbit/earth_tiles.h>
#include <scenes/orbit/station.h>
#include <scenes/scene_builder.h>

#include <functional>

namespace cdr::scenes {

/// Where the airport of the scene orbit is: the threshold of runway 09L at London Heathrow, below the track
/// of the ISS. The place is real, what is built there is not.
inline constexpr Geodetic kOrbitAirport{51.4775, -0.4850};
inline constexpr double kStationHeight = 420e3; ///< metres above the ellipsoid
inline constexpr double kStationWest = 90e3; ///< metres on the ground from below the station to the airport
inline constexpr double kMoonDistance = 384.4e6; ///< metres, from the Earth's centre
inline constexpr double kMoonRadius = 1'737.4e3;

/// Towards the Sun, unit, world space.
glm::dvec3 orbitToSun();

/// The station's place and heading: over the country west of the airport, looking east.
StationPose orbitStation(const EarthSurface& surface);

/// The detail that the station and the airport ask of the Earth.
TileDetail orbitDetail(const StationPose& station);

/// What a tile of the ground wears: a material, and the rectangle that its texture shows.
struct TileCoat {
    std::uint32_t material = 0;
    GeodeticFrame frame{};
};

/// Adds the materials of the ground, and returns what says which of them a tile wears.
using GroundCover = std::function<std::function<TileCoat(const EarthTile&)>(SceneBuilder&)>;

/// The real-life scene (the thesis' future work). It has a station's window 420 km up, the real Earth below it, the
/// Moon behind, and an airport on the ground. The airport's slab lies 2 cm over the soil, and paint 5 mm over the
/// slab. One unit is a metre, and one world space holds all of it in float64. The path zooms from the window, at
/// 60 degrees, to the numbers of the runway, at 0.002 degrees, in 240 frames. Near is 0.1, and far is beyond the
/// Moon.
/// @param maps moved into the scene's texture.
/// @param parked a model to stand on the apron instead of the generated aircraft; may be null.
scene::SceneSetup makeOrbit(EarthMaps maps, const scene::Scene* parked = nullptr);

/// makeOrbit() with another ground on the same surface.
scene::SceneSetup makeOrbitOn(const EarthSurface& surface, const GroundCover& cover,
                              const scene::Scene* parked = nullptr);

/// makeOrbit() of what the files hold. base::InputError as loadEarthMaps() and loadGltf().
scene::OpenedScene openOrbit(const OrbitFiles& files);

} // namespace cdr::scenes
