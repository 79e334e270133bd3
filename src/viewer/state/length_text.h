#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cdr::viewer {

/// A length with a unit from micrometres (µm) over mm, m and km to million km, and no digit finer than
/// `stepMetres`: "420.0013 km", "5.00 mm". At least one digit, at most 17; 0 steps give 4 digits. Not finite
/// is "infinite"; below a step, "0" with the step's unit.
std::string lengthText(double metres, double stepMetres = 0.0);

/// "1 flip", "2 flips".
std::string counted(std::uint64_t count, std::string_view noun);

/// What to say of a picture that has been waited for so long; nothing below half a second.
std::string lagText(double seconds);

/// A step or an uncertainty: two significant digits, such as "2.4 µm".
std::string stepText(double metres);

} // namespace cdr::viewer
