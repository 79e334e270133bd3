#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/base/result.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace cdr::depth {

/// A view-distance interval [nearView, farView) with a depth range of its own (the thesis: sub-frustum).
struct Cascade {
    double nearView = 0.0; ///< > 0
    double farView = 0.0;  ///< > nearView

    /// Whether the interval holds a view distance; half-open.
    bool contains(double distanceView) const { return distanceView >= nearView && distanceView < farView; }
    bool operator==(const Cascade&) const = default;
};

/// Nearest first; each begins at or beyond the end of the one before.
using Cascades = std::vector<Cascade>;

/// Most cascades that a split may give; the id buffer keeps the cascade in one byte.
inline constexpr std::size_t kMaxCascades = 64;

/// The range of near and far planes. Within it, what a cascade hands to shaders is a normal float32, and no formula of
/// this library overflows or underflows float64. Devices take smaller numbers for 0. Terms of a cascade as thin as float32
/// resolves are 2^24 times smaller or larger than its distances, so the range ends that much before float32's.
inline constexpr double kMinView = 1e-30;
/// The same at the other end.
inline constexpr double kMaxView = 1e30;
/// The greatest far plane over its near plane: shaders compute depths of about near / far, and distances over near.
inline constexpr double kMaxFarOverNear = 1e36;

/// Why these are no near and far plane: empty where kMinView <= near < far <= kMaxView and far <= kMaxFarOverNear * near.
CDR_EXPORT std::optional<base::Refusal> rangeProblem(double nearView, double farView);
/// @throws base::InputError where there is a rangeProblem().
CDR_EXPORT void requireRange(double nearView, double farView);

} // namespace cdr::depth
