#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

struct LadderOptions {
    double distanceView = 1e6; ///< from the camera to the field's centre
    double smallestSeparation = 1e-6;
    double largestSeparation = 1.0;
    double nearView = 0.001;
    double farView = 2e6;
    /// Shrinks cubes, grid and separations alike: the field is 32 units wide, too wide to be close to.
    double scale = 1.0;
    /// How deep the front of a pair is, as a share of a cube. Below 1 the two differ, and float32 rounds each of them in its
    /// own way. Their faces to the camera stay where they are.
    double frontDepth = 1.0;
};

/// Pairs of unit cubes, the second shifted towards +z by a separation. 256 pairs lie on a 16x16 grid 2 units
/// apart. Separations are in equal ratios, depth is jittered, and draw order within a pair is random. Pair p
/// is the objects 2p and 2p + 1. The camera stands 20 degrees about y off the z axis, its lens set so a cube
/// covers about 20 of 720 pixels.
scene::SceneSetup makeLadder(std::uint64_t seed, const LadderOptions& options = {});

/// Pairs on a ladder, and the separation of each, scale included.
inline constexpr std::uint32_t kLadderPairs = 256;
double ladderSeparation(const LadderOptions& options, std::uint32_t pair);

} // namespace cdr::scenes
