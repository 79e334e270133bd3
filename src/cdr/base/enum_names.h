#pragma once

#include <cdr/base/result.h>
#include <cdr/base/suggest.h>

#include <algorithm>
#include <array>
#include <cstddef>
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

} // namespace cdr::base
