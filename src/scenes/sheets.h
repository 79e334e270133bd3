#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

/// Translucent sheets from one end of the view to the other: near 0.1, far 10^6, 60 degrees. Their distances
/// are spread evenly in logarithm and each reaches from about half to twice its own, turned every way. So
/// whatever the split, sheets cross its boundaries at all angles, and each other. Some are textured, some
/// unlit, some single-sided, some are closed boxes; opaque cubes stand between them at every decade.
/// @param sheets translucent objects, 64 as the experiments have it; the opaque ones come after them.
scene::SceneSetup makeSheets(std::uint64_t seed, std::uint32_t sheets = 64);

/// A square in the plane z = 0 from -halfSide to halfSide, its front towards +z.
scene::Mesh makeSquare(float halfSide);

} // namespace cdr::scenes
