#pragma once

/// @file
/// @errors None but those that a function names.
/// @lifetime References, and names, live as long as the program.

#include <cdr/base/export.h>
#include <cdr/base/result.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace cdr::depth {

/// What a depth buffer stores: 16 or 24 bits of unsigned fraction, or a 32-bit float.
enum class DepthFormat : std::uint8_t { d16, d24, d32f };

/// All of them, coarsest first.
inline constexpr std::array kDepthFormats{DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};

/// What is known of each format, by DepthFormat.
struct DepthFormatTraits {
    std::string_view name; ///< as nameOf() gives it
    int bits = 0;          ///< of one value
    bool isFloat = false;  ///< else a fraction
};
/// By DepthFormat.
inline constexpr std::array<DepthFormatTraits, kDepthFormats.size()> kDepthFormatTraits{{
    {.name = "d16", .bits = 16, .isFloat = false},
    {.name = "d24", .bits = 24, .isFloat = false},
    {.name = "d32f", .bits = 32, .isFloat = true},
}};
/// What is known of a format.
constexpr const DepthFormatTraits& traitsOf(DepthFormat format) {
    return kDepthFormatTraits[static_cast<std::size_t>(format)];
}

/// "d16", "d24" or "d32f".
constexpr std::string_view nameOf(DepthFormat format) {
    return traitsOf(format).name;
}

/// Their names, for lists in messages and in JSON.
CDR_EXPORT std::vector<std::string_view> namesOf(std::span<const DepthFormat> formats);

/// @throws base::InputError with a suggestion for any other name.
CDR_EXPORT DepthFormat parseDepthFormat(std::string_view name);
/// parseDepthFormat(), refused instead of thrown.
CDR_EXPORT base::Result<DepthFormat> tryParseDepthFormat(std::string_view name);

/// The gap between neighbouring values of the depth buffer around depth `zNdc` in [0, 1]. It is 1 / (2^bits - 1)
/// for the fractions (Vulkan: fixed-point conversion), and the spacing of float32 just below zNdc for the float.
CDR_EXPORT double depthStep(DepthFormat format, double zNdc);

/// A depth as the buffer would store it, rounded to nearest.
/// @param zNdc in [0, 1], of the depth buffer, as the result is.
CDR_EXPORT double quantize(DepthFormat format, double zNdc);

} // namespace cdr::depth
