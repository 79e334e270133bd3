#pragma once

#include <cdr/image/image.h>
#include <cdr/scene/gltf/gltf.h>

#include <array>
#include <filesystem>

namespace cdr::scenes {

/// The real Earth as pictures: whole, plate carree, the north on top, 180 degrees west at the left edge.
struct EarthMaps {
    image::ImageRgba8 color;      ///< NASA Blue Marble, sRGB
    image::ImageRgba8 topography; ///< grey: kMetresPerGrey each, sea level 0
};

/// Metres for each grey value of the topography. It was checked against 11 places of known elevation, from Madrid
/// (26 at 650 m) to Tibet (202 at 5,000 m). Each gives 23.6 to 27.0.
inline constexpr double kMetresPerGrey = 25.0;

/// The files of the maps, as the npm package three-globe names them.
inline constexpr const char* kEarthColor = "earth-blue-marble.jpg";
inline constexpr const char* kEarthTopography = "earth-topology.png";

/// Both, in a folder.
std::array<std::filesystem::path, 2> earthFiles(const std::filesystem::path& folder);

/// What the scene orbit is made of.
struct OrbitFiles {
    std::filesystem::path folder; ///< of the maps
    std::filesystem::path model;  ///< glTF, to be parked at the airport; empty for the generated aircraft
    scene::GltfLimits limits{};   ///< of the model
};

/// The folder that the environment variable CDR_ORBIT_DATA names, else where tools/setup.sh puts the maps;
/// the model that CDR_ORBIT_MODEL names, else none.
OrbitFiles orbitFiles();

/// Reads kEarthColor and kEarthTopography.
/// base::InputError, naming tools/setup.sh, when one is missing; or when one is damaged.
EarthMaps loadEarthMaps(const std::filesystem::path& folder);

} // namespace cdr::scenes
