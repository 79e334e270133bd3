#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>

namespace cdr::scenes {

/// From 0 at `low` to 1 at `high`, without an edge at either.
inline double smoothStep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// What lies between two numbers. As std::lerp(), except for its care at the ends, which takes longer than all else here.
inline double blend(double a, double b, double share) {
    return a + share * (b - a);
}

/// A number that belongs to a cell of a plane, 0 to below 1: the same on every machine.
double cellNumber(std::int64_t column, std::int64_t row, std::uint32_t seed);

/// The integer below a position. As std::floor(), which calls a function on processors that all machines have.
inline std::int64_t cellOf(double position) {
    const auto towardsZero = static_cast<std::int64_t>(position);
    return towardsZero - (position < static_cast<double>(towardsZero) ? 1 : 0);
}

/// Smooth noise of one wavelength, -1 to 1 and 0 on average, and how it changes per unit.
struct Wave {
    double value = 0.0;
    glm::dvec2 slope{0.0};
};

/// @param place and `length` in one unit; length: from one hill to the next, at least.
Wave waveAt(const glm::dvec2& place, double length, std::uint32_t seed);

/// Waves that halve in length, and by `gain` in height, from `longest` to those that texels of a size can show. Shorter ones fade
/// out, so that finer textures add to coarser ones, and nothing jumps.
struct Waves {
    double longest = 1.0;
    double shortest = 0.0;
    double gain = 0.5;
    std::uint32_t seed = 0;
};

/// Which of the waves are summed: those that a coarse grid of `kGridTexels` shows as well, and the rest.
enum class WavePart : std::uint8_t { all, ofGrid, beyondGrid };
inline constexpr std::uint32_t kGridTexels = 4;

/// How finely a place of a picture is painted, in the unit of the place.
struct Fineness {
    double texel = 1.0;   ///< what is smaller is left out; at least `picture`
    double picture = 1.0; ///< a texel of the picture, of which the coarse grid has one in `kGridTexels`
};

/// The sum of waves at a place; the longest has a height of 1.
/// @param texel in the unit of the place.
double sumWaves(const Waves& waves, const glm::dvec2& place, double texel);

/// A part of the sum: the two parts add up to it.
double sumWaves(const Waves& waves, const glm::dvec2& place, const Fineness& fineness, WavePart part);

/// How high the waves of a sum are that texels of a size leave out, as a root of the sum of squares.
double leftOut(const Waves& waves, double texel);

/// How well texels of a size show what is so long: 0 below two texels, 1 from four on.
double shownBy(double texel, double length);

} // namespace cdr::scenes
