#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::scene {

/// How values between two keyframes are found (glTF 2.0, appendix C).
enum class Interpolation : std::uint8_t { step, linear, cubicSpline };

/// Values at moments of an animation. Each value is `width` numbers; with cubic splines three values stand for a keyframe:
/// in-tangent, value, out-tangent.
struct Keyframes {
    Interpolation interpolation = Interpolation::linear;
    std::size_t width = 1;     ///< numbers of a value, at least 1
    std::vector<float> times;  ///< seconds, finite, increasing, at least one; two with cubic splines
    std::vector<float> values; ///< finite, `width` for each time, or three times as many
};

/// Writes the value at a moment to `value`, which has Keyframes::width numbers. Before the first keyframe and after the last
/// one their values hold.
void sampleAt(const Keyframes& keyframes, double seconds, std::span<double> value);

/// The same of rotations, whose four numbers are a quaternion x, y, z, w. Linear turns by the shorter way at an even pace
/// (slerp). The result has length one.
glm::dquat rotationAt(const Keyframes& keyframes, double seconds);

} // namespace cdr::scene
