#pragma once

/// @file
/// @errors None but those that a function names.

#include <array>
#include <string>
#include <string_view>

namespace cdr::base {

/// What a length is written in. `automatic` is the largest of µm, mm, m, km and million km of which the length is at least 1.
/// `none` is the scene unit, and no unit is written.
enum class LengthUnit { none, automatic, micrometre, millimetre, metre, kilometre };
/// All of them.
inline constexpr std::array kLengthUnits{LengthUnit::none,       LengthUnit::automatic,
                                         LengthUnit::micrometre, LengthUnit::millimetre,
                                         LengthUnit::metre,      LengthUnit::kilometre};
/// "none", "auto", "um", "mm", "m", "km".
/// @lifetime The program's.
std::string_view nameOf(LengthUnit unit);
/// The unit of a name.
/// @throws InputError with a suggestion for an unknown name.
LengthUnit parseLengthUnit(std::string_view name);

/// `typeset` is for windows and pages: thousands grouped, a true minus, powers of ten raised, no place to break a line.
/// `plain` is for terminals: what it writes without a unit can be typed in again.
enum class NumberStyle { typeset, plain };

/// Significant digits by default.
inline constexpr int kReadableDigits = 4;

/// A number as people read it, in every program of cdr. It has `digits` significant digits, but all digits of a whole number
/// below ten million. It has no zeros at the end. Below 0.0001 and from ten million on it has a power of ten. An infinite
/// value is "infinite", and a value that is no number is "none". The report's page follows the same rules: see
/// tests/base/quantities.json.
/// @param value in any unit, which the text leaves out.
std::string quantityText(double value, NumberStyle style = NumberStyle::typeset,
                         int digits = kReadableDigits);

/// A length as quantityText() in a unit.
/// @param metres scene units, which are metres by convention.
std::string quantityText(double metres, LengthUnit unit, NumberStyle style = NumberStyle::typeset,
                         int digits = kReadableDigits);

} // namespace cdr::base
