#pragma once

#include <cdr/base/result.h>
#include <cdr/base/suggest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace cdr::base {

/// The names of an enumeration whose values count from 0: one table, read in both directions.
template <typename Enum, std::size_t Count>
struct EnumNames {
    std::string_view what;                     ///< what messages call a value: "depth mapping"
    std::array<std::string_view, Count> names; ///< by value

    /// The name of a value of the enumeration, which is not checked.
    /// @errors None.
    /// @lifetime That of the text in `names`: of a literal, the program's.
    constexpr std::string_view nameOf(Enum value) const { return names[static_cast<std::size_t>(value)]; }

    /// Refused with a suggestion: an unknown name.
    /// @errors None.
    Result<Enum> tryParse(std::string_view name) const {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            return Refusal{unknownName(what, name, names)};
        }
        return static_cast<Enum>(found - names.begin());
    }

    /// @throws InputError with a suggestion for an unknown name.
    Enum parse(std::string_view name) const { return tryParse(name).orThrow(); }
};

/// A value's row in a table that explains each value.
struct ExplainedName {
    std::string_view name;        ///< as the command line has it
    std::string_view explanation; ///< a sentence or two: what the value does, and what it is good and bad at
};

/// The names of such a table, for EnumNames.
/// @errors None.
template <std::size_t Count>
constexpr std::array<std::string_view, Count> namesOf(const std::array<ExplainedName, Count>& rows) {
    std::array<std::string_view, Count> names;
    for (std::size_t i = 0; i < Count; ++i) {
        names[i] = rows[i].name;
    }
    return names;
}

/// "a, b or c": the names of all values of an enumeration that has a nameOf().
/// @errors None.
template <typename Enum, std::size_t Count>
std::string listNames(const std::array<Enum, Count>& values) {
    std::string list;
    for (std::size_t i = 0; i < Count; ++i) {
        list += i == 0 ? "" : i + 1 == Count ? " or " : ", ";
        list += nameOf(values[i]);
    }
    return list;
}

} // namespace cdr::base
