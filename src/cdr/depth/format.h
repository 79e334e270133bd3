#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cdr::depth {

/// What a depth buffer stores: 16 or 24 bits of unsigned fraction, or a 32-bit float.
enum class DepthFormat : std::uint8_t { d16, d24, d32f };

inline constexpr std::array kDepthFormats{DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};

/// "d16", "d24" or "d32f".
std::string_view nameOf(DepthFormat format);

/// base::InputError with a suggestion for any other name.
DepthFormat parseDepthFormat(std::string_view name);

/// The gap between neighbouring stored values around depth `zNdc` in [0, 1]: 1 / (2^bits - 1) for the
/// fractions (Vulkan: fixed-point conversion), the spacing of float32 just below zNdc for the float.
double depthStep(DepthFormat format, double zNdc);

/// `zNdc` as the buffer would store it, rounded to nearest.
double quantize(DepthFormat format, double zNdc);

} // namespace cdr::depth
