#pragma once

/// @file
/// @errors None.

#include <cdr/base/export.h>

#include <array>

namespace cdr::depth {

/// A float64 number as two floats, for devices without float64.
struct FloatPair {
    float value = 0.0f; ///< the nearest float
    float rest = 0.0f;  ///< what it leaves out, to 2^-48 of a number of 1e-23 or more in magnitude
};

/// A number in two parts, in the unit that it is in. 48 of its 53 bits stay, less where the rest is below the least normal float.
/// @param number at most float's greatest value in magnitude.
CDR_EXPORT FloatPair floatPair(double number);

/// Where a camera is and which way it looks, in world space, all in float64.
struct ViewAxes {
    std::array<double, 3> eye{};                   ///< its position
    std::array<double, 3> right{1.0, 0.0, 0.0};    ///< unit vector
    std::array<double, 3> up{0.0, 1.0, 0.0};       ///< unit vector
    std::array<double, 3> forward{0.0, 0.0, -1.0}; ///< unit vector, along which view distance grows
};

/// What a device without float64 needs to place the objects that it moves or culls itself: CdrView of
/// shaders/public/cdr_view.glsl. Its eight vec4 have the same 128 bytes in every kind of buffer. One serves all cascades.
struct ViewConstants {
    std::array<float, 4> eye{};         ///< ViewAxes::eye; the fourth is unused, here and below
    std::array<float, 4> eyeRest{};     ///< what `eye` leaves out, as in FloatPair
    std::array<float, 4> right{};       ///< ViewAxes::right
    std::array<float, 4> rightRest{};   ///< what `right` leaves out
    std::array<float, 4> up{};          ///< ViewAxes::up
    std::array<float, 4> upRest{};      ///< what `up` leaves out
    std::array<float, 4> forward{};     ///< ViewAxes::forward
    std::array<float, 4> forwardRest{}; ///< what `forward` leaves out
};
static_assert(sizeof(ViewConstants) == 128);

/// The constants of a camera.
CDR_EXPORT ViewConstants viewConstants(const ViewAxes& axes);

} // namespace cdr::depth
