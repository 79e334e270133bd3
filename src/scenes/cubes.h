#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

/// Figures 6.1 to 6.3: a field of 1000 cubes 12,000 units away, near 0.01, far 100,000. The thesis gives
/// neither lens nor field. Here it is the afc field scaled 10 times, which fills the width of a 16:9 picture
/// through a 0.87 degree lens. Cubes are listed nearest first, as an engine that sorts for early depth tests
/// submits them. So a depth buffer that resolves nothing shows the farthest.
scene::SceneSetup makeCubes(std::uint64_t seed);

/// The 2AFC scene (thesis section 6.1.2): 1000 unit cubes at random in a 32^3 field about the origin. A white
/// point light is at its centre. The camera circles it once in 360 frames, at 10^6 units. Its lens is 0.002
/// degrees, near 0.001, far 2 10^6.
scene::SceneSetup makeAfc(std::uint64_t seed);

/// The 2AFC scene with something beside the camera, as in any real one. A cube of side 0.002 stays 0.01 ahead
/// of the camera in a corner of a 16:9 picture. So near must stay at 0.001, and fitting near and far alone
/// does not help. One such cube per frame of the path, since scenes do not move. Far is 1 less, so that none
/// shows up behind the field.
scene::SceneSetup makeAfcNear(std::uint64_t seed);

/// The timing scene (thesis section 6.2): unit cubes at random in a 400^3 field, and one point light. The camera
/// is in the middle and turns once about y. Its lens is 60 degrees, near 0.1, far 100,000.
/// @param cubes 64,000 in the thesis.
scene::SceneSetup makeRotation(std::uint64_t seed, std::uint32_t cubes = 64'000);

/// Unit cubes all in view and about a pixel each at 640x360. So drawing them costs draws rather than
/// pixels. 60 degrees, near 100, far 10,000. Their distances are spread evenly in logarithm, so that each
/// cascade of a count:K split gets about an equal share.
/// @param aspect width over height of the picture, > 0.
scene::SceneSetup makeCrowd(std::uint64_t seed, std::uint32_t cubes, double aspect = 16.0 / 9.0);

} // namespace cdr::scenes
