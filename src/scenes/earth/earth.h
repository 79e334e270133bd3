#pragma once

#include <scenes/orbit/orbit.h>

namespace cdr::scenes {

struct EarthOptions {
    /// Texels of a block of the ground from north to south, a multiple of 16. From west to east it has half as many, which are as
    /// wide as those are high, since the airport lies far north. So the horizon is sharper, too: few texels lie behind each other.
    /// The block that the station sees from afar has twice as many each way, and the two beyond half as many.
    std::uint32_t blockTexels = 1280;
    std::size_t threads = 0; ///< that paint the ground; 0: as many as the machine has
};

/// makeOrbit() as a picture: with air, clouds, and a ground that stays sharp on the whole way down to the runway. Objects, their
/// places and the path are the same. Clouds and what the blue marble does not resolve are generated.
scene::SceneSetup makeEarth(const EarthMaps& maps, const scene::Scene* parked = nullptr,
                            const EarthOptions& options = {});

/// makeEarth() of what the files hold. base::InputError as openOrbit().
scene::OpenedScene openEarth(const OrbitFiles& files);

} // namespace cdr::scenes
