#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::scene::gltf {

/// In which order to read elements, so that none of their blocks is read twice (block_cache.h). The result is indices into
/// `elements`, sorted by the element. Empty if any order will do, since their blocks are all kept.
/// @param bytesApart from one element to the next, of all that is read of an element; 0 if all of it is in memory.
std::vector<std::uint32_t> readingOrder(std::span<const std::uint32_t> elements, std::size_t bytesApart);

/// Calls back with each place in that order.
/// @param elements how many there are.
template <typename Read>
void forEachInOrder(std::span<const std::uint32_t> order, std::size_t elements, const Read& read) {
    for (std::size_t i = 0; i < elements; ++i) {
        read(order.empty() ? static_cast<std::uint32_t>(i) : order[i]);
    }
}

} // namespace cdr::scene::gltf
