#pragma once

#include <vector>

namespace cdr::depth {

/// A view-distance interval [nearView, farView) with a depth range of its own (the thesis: sub-frustum).
struct Cascade {
    double nearView = 0.0; ///< > 0
    double farView = 0.0;  ///< > nearView

    bool contains(double distanceView) const { return distanceView >= nearView && distanceView < farView; }
    bool operator==(const Cascade&) const = default;
};

/// Nearest first; each begins at or beyond the end of the one before.
using Cascades = std::vector<Cascade>;

/// Most cascades a split may give; the id buffer keeps the cascade in one byte.
inline constexpr std::size_t kMaxCascades = 64;

} // namespace cdr::depth
