#pragma once

#include <cstdint>

namespace cdr::experiments {

/// Whether a pixel is not at the border of a picture.
template <typename Picture>
bool isInside(std::uint32_t x, std::uint32_t y, const Picture& picture) {
    return x > 0 && y > 0 && x + 1 < picture.width && y + 1 < picture.height;
}

/// Whether all neighbours of a pixel, which is not at the border, are as `isAlike` says.
template <typename IsAlike>
bool isAmongAlike(std::uint32_t x, std::uint32_t y, IsAlike isAlike) {
    for (std::uint32_t j = y - 1; j <= y + 1; ++j) {
        for (std::uint32_t i = x - 1; i <= x + 1; ++i) {
            if (!isAlike(i, j)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace cdr::experiments
