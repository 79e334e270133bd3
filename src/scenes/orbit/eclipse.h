#pragma once

#include <scenes/orbit/orbit.h>

namespace cdr::scenes {

/// makeOrbit() with the Moon before the Sun, for shadows from millimetres to the Moon's. There are bolts of 4 mm on the
/// window's frame, hangars of 18 m at the airport, and the Moon's disc on the Earth. The station and the airport stay in the
/// Sun.
///
/// The path shows each for kEclipseStopFrames frames while the camera moves a little. It shows the bolts, the hangars through
/// a lens of 0.06 degrees, the disc from the station, and the whole Earth from 60,000 km.
/// @param maps moved into the scene's texture.
scene::SceneSetup makeEclipse(EarthMaps maps);

/// makeEclipse() of what the files hold. base::InputError as loadEarthMaps().
scene::SceneSetup openEclipse(const OrbitFiles& files);

inline constexpr std::uint32_t kEclipseStopFrames = 30;

} // namespace cdr::scenes
