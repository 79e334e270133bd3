#pragma once

#include <cdr/base/export.h>

#include <array>
#include <cstdint>

namespace cdr::image {

/// Linear light, 0 to 1, of each 8-bit sRGB value (IEC 61966-2-1).
CDR_EXPORT const std::array<double, 256>& linearOfSrgb();

/// The nearest 8-bit sRGB value of linear light, which is clamped to 0 to 1 first.
CDR_EXPORT std::uint8_t srgbOfLinear(double linear);

} // namespace cdr::image
