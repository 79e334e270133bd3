#pragma once

#include <cmath>
#include <limits>

namespace cdr::scene {

/// The least float that is no less than a number.
inline float roundedUp(double number) {
    const auto nearest = static_cast<float>(number);
    return static_cast<double>(nearest) < number
               ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
               : nearest;
}

} // namespace cdr::scene
