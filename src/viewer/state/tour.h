#pragma once

#include <cstdint>
#include <string_view>

namespace cdr::viewer {

inline constexpr const char* kTourScene = "orbit";
/// How long the tour takes, seconds.
inline constexpr double kTourSeconds = 40.0;

/// The frame of a path of so many that the tour shows after `seconds`; its last from kTourSeconds on.
std::uint32_t tourFrame(double seconds, std::uint32_t frames);

/// What the tour says of a picture through such a lens.
std::string_view tourCaption(double fovDegrees);

} // namespace cdr::viewer
