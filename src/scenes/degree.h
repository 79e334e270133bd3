#pragma once

#include <numbers>

namespace cdr::scenes {

/// Radians.
inline constexpr double kDegree = std::numbers::pi / 180.0;

} // namespace cdr::scenes
