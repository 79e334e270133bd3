#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::scene {

/// Divides clusters into groups of neighbours. Each takes part in one group. The same groups each time.
/// @param clusters the indices of each.
/// @param places by index: which point of space it is; indices that are at one point have the same.
/// @param most clusters in a group.
std::vector<std::vector<std::size_t>> groupClusters(std::span<const std::vector<std::uint32_t>> clusters,
                                                    std::span<const std::uint32_t> places, std::size_t most);

} // namespace cdr::scene
