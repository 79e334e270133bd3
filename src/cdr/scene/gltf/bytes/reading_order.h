#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::scene::gltf {

/// In which order to read elements, so that none of the blocks that they are in is read twice (block_cache.h): places in
/// `elements`, by the element. Empty where they can be read as they are, since their blocks are kept.
/// @param bytesApart from one element to the next, all that is read of an element together; 0 if all of it is in memory.
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
