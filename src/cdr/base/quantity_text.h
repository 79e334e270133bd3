#pragma once

/// @file
/// @errors None but those that a function names.

#include <array>
#include <string>
#include <string_view>

namespace cdr::base {

/// What a length is written in. `automatic` is the largest of µm, mm, m, km and million km that it fills, `none` the scene
/// unit without a word.
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

/// Significant digits where nobody says otherwise.
inline constexpr int kReadableDigits = 4;

/// A number as people read it, in every program of cdr: so many significant digits, but all whole ones below ten million,
/// and no zeros at the end. A power of ten below 0.0001 and from ten million on. "infinite", and "none" for no number.
/// tests/base/quantities.json holds it to the report's page, which follows the same rules.
/// @param value in any unit, which the text leaves out.
std::string quantityText(double value, NumberStyle style = NumberStyle::typeset,
                         int digits = kReadableDigits);

/// A length as quantityText() in a unit.
/// @param metres scene units, which are metres by convention.
std::string quantityText(double metres, LengthUnit unit, NumberStyle style = NumberStyle::typeset,
                         int digits = kReadableDigits);

} // namespace cdr::base
