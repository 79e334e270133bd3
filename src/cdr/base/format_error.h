#pragma once

#include <cdr/base/error.h>

#include <fmt/format.h>

#include <utility>

namespace cdr::base {

/// An error to throw, whose message fmt::format() makes.
template <typename... Values>
InputError inputError(fmt::format_string<Values...> message, Values&&... values) {
    return InputError(fmt::format(message, std::forward<Values>(values)...));
}

/// The same for a RunError.
template <typename... Values>
RunError runError(fmt::format_string<Values...> message, Values&&... values) {
    return RunError(fmt::format(message, std::forward<Values>(values)...));
}

} // namespace cdr::base
