#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

struct BoulderOptions {
    std::uint32_t boulders = 200;
    std::uint32_t shapes = 4;       ///< meshes, taken in turn
    std::uint32_t subdivisions = 5; ///< of an icosahedron: 20 4^subdivisions triangles a mesh, at most 8
};

/// A field of dense meshes from near to far, for levels of detail: boulders, spheres with bumps down to a
/// tenth of their radius. Their view distances are 8 to 4000, evenly in logarithm, and their radius grows
/// with the root of the distance. All are in view and apart. 60 degrees, near 0.5, far 10,000; in 360 frames
/// the camera circles once at radius 3, looking ahead. 4.1 million triangles by default. base::InputError for no shapes or
/// too many of anything.
scene::SceneSetup makeBoulders(std::uint64_t seed, const BoulderOptions& options = {});

/// One boulder of bounding radius 1 or a little less, closed and smooth; the seed decides its bumps.
scene::Mesh makeBoulder(std::uint64_t seed, std::uint32_t subdivisions);

} // namespace cdr::scenes
