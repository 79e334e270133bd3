#pragma once

#include <cdr/scene/scene_setup.h>

#include <array>
#include <cstdint>

namespace cdr::scenes {

/// View distances of the mixed scene, its separations as shares of them, and pairs of cubes for each of both.
inline constexpr std::array kMixedDistances{1.0, 1e3, 1e6, 1e8};
inline constexpr std::array kMixedShares{1e-6, 1e-7};
inline constexpr std::uint32_t kMixedPairsPerCell = 9;
inline constexpr std::uint32_t kMixedPairs =
    kMixedDistances.size() * kMixedShares.size() * kMixedPairsPerCell;

/// Four distances in one picture, for each a column of cubes, a corner towards the eye. Each cube has a red
/// twin behind it whose faces lie a share of the distance below its own. It is 1e-6 in the upper half and
/// 1e-7 in the lower. Twins are drawn last, so a depth buffer that cannot tell the two apart shows red.
/// Finer shares would ask for more than float32 x and y have. 20 degrees, near 0.1, far 2e8. Pair p, column
/// by column and in each from the top, is the objects 2p and its twin 2p + 1.
scene::SceneSetup makeMixed();

} // namespace cdr::scenes
