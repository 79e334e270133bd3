#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace cdr::runs {

/// A fresh order of what is compared for each frame, so that what one leaves in the caches burdens all others
/// alike.
class ShuffledOrder {
  public:
    ShuffledOrder(std::size_t modes, std::uint64_t seed) : m_random(seed), m_order(modes) {
        std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    }

    const std::vector<std::size_t>& next() {
        // Fisher and Yates by hand: std::shuffle may differ between standard libraries.
        for (std::size_t i = m_order.size(); i > 1; --i) {
            std::swap(m_order[i - 1], m_order[m_random() % i]);
        }
        return m_order;
    }

  private:
    std::mt19937_64 m_random;
    std::vector<std::size_t> m_order;
};

} // namespace cdr::runs
