#pragma once

#include <cdr/scene/staged_scene.h>

#include <cstdint>

namespace cdr::scenes {

/// Figures 6.1 to 6.3: a field of 1000 cubes 12,000 units away, near 0.01, far 100,000. The thesis gives
/// neither lens nor field: here the afc field scaled 10 times, which fills the width of a 16:9 picture
/// through a 0.87 degree lens. Cubes are listed nearest first, as an engine that sorts for early depth tests
/// submits them, so a depth buffer that tells nothing apart shows the farthest.
scene::StagedScene makeCubes(std::uint64_t seed);

/// The 2AFC scene (thesis section 6.1.2): 1000 unit cubes at random in a 32^3 field about the origin, a white
/// point light at its centre, the camera at 10^6 units circling once in 360 frames; 0.002 degrees, near
/// 0.001, far 2 10^6.
scene::StagedScene makeAfc(std::uint64_t seed);

/// The 2AFC scene with something beside the camera, as in any real one: a cube of side 0.002 stays 0.01 ahead
/// of the camera in a corner of a 16:9 picture, so near must stay at 0.001 and fitting near and far alone
/// does not help. One such cube per frame of the path, since scenes do not move; far is 1 less, so that none
/// shows up behind the field.
scene::StagedScene makeAfcNear(std::uint64_t seed);

/// The timing scene (thesis section 6.2): unit cubes at random in a 400^3 field, one point light, the camera
/// in the middle turning once about y; 60 degrees, near 0.1, far 100,000.
/// @param cubes 64,000 in the thesis.
scene::StagedScene makeRotation(std::uint64_t seed, std::uint32_t cubes = 64'000);

/// Unit cubes all in view and about a pixel each at 640x360, so that drawing them costs draws rather than
/// pixels: 60 degrees, near 100, far 10,000. Their distances are spread evenly in logarithm, so that each
/// cascade of a count:K split gets about an equal share.
/// @param aspect width over height of the picture, > 0.
scene::StagedScene makeCrowd(std::uint64_t seed, std::uint32_t cubes, double aspect = 16.0 / 9.0);

struct LadderOptions {
    double distanceView = 1e6; ///< from the camera to the field's centre
    double smallestSeparation = 1e-6;
    double largestSeparation = 1.0;
    double nearView = 0.001;
    double farView = 2e6;
    /// Shrinks cubes, grid and separations alike: the field is 32 units wide, too wide to be close to.
    double scale = 1.0;
};

/// Pairs of unit cubes, the second shifted towards +z by a separation; 256 pairs on a 16x16 grid 2 units
/// apart, separations in equal ratios, depth jittered, draw order within a pair random. Pair p is the objects
/// 2p and 2p + 1. The camera stands 20 degrees about y off the z axis, its lens set so a cube covers about 20
/// of 720 pixels.
scene::StagedScene makeLadder(std::uint64_t seed, const LadderOptions& options = {});

/// Pairs on a ladder, and the separation of each, scale included.
inline constexpr std::uint32_t kLadderPairs = 256;
double ladderSeparation(const LadderOptions& options, std::uint32_t pair);

} // namespace cdr::scenes
