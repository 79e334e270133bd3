#include "reading_order.h"

#include "block_cache.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cdr::scene::gltf {

namespace {

/// Places by element, where many of the elements between the least and the most are there.
std::vector<std::uint32_t> orderOfDense(std::span<const std::uint32_t> elements, std::uint32_t least,
                                        std::uint32_t most) {
    std::vector<std::uint32_t> next(std::size_t{most} - least + 2, 0); // by element, where its places go
    for (const std::uint32_t element : elements) {
        ++next[element - least + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<std::uint32_t> order(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        order[next[elements[i] - least]++] = static_cast<std::uint32_t>(i);
    }
    return order;
}

std::vector<std::uint32_t> orderOfSparse(std::span<const std::uint32_t> elements) {
    std::vector<std::uint32_t> order(elements.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(elements[a], a) < std::pair(elements[b], b);
    });
    return order;
}

} // namespace

std::vector<std::uint32_t> readingOrder(std::span<const std::uint32_t> elements, std::size_t bytesApart) {
    // Other blocks are in use as well.
    constexpr std::uint64_t kMaxBytesInAnyOrder = BlockCache::kBytes / 2;
    if (bytesApart == 0 || elements.empty()) {
        return {};
    }
    const auto [least, most] = std::minmax_element(elements.begin(), elements.end());
    if (std::uint64_t{bytesApart} * (*most - *least) <= kMaxBytesInAnyOrder ||
        std::is_sorted(elements.begin(), elements.end())) {
        return {};
    }
    return *most - *least < 2 * elements.size() ? orderOfDense(elements, *least, *most)
                                                : orderOfSparse(elements);
}

} // namespace cdr::scene::gltf
