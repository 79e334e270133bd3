#pragma once

/// @file
/// @errors None.
/// @units Any: the text leaves the unit out.

#include <string>
#include <type_traits>

namespace cdr::base {

/// The shortest text that reads back as the same value. Without an exponent from 1e-4 up to 1e16, as fmt writes "{}".
std::string shortest(double value);

/// As many significant digits as given, trailing zeros left out: printf's "%.Ng".
std::string general(double value, int digits = 6);

/// As many decimals as given: printf's "%.Nf".
std::string fixed(double value, int decimals);

/// The texts one after another, numbers in between by shortest().
template <typename... Parts>
std::string concat(const Parts&... parts) {
    std::string text;
    const auto append = [&text](const auto& part) {
        if constexpr (std::is_floating_point_v<std::decay_t<decltype(part)>>) {
            text += shortest(part);
        } else if constexpr (std::is_integral_v<std::decay_t<decltype(part)>>) {
            text += std::to_string(part);
        } else {
            text += part;
        }
    };
    (append(parts), ...);
    return text;
}

} // namespace cdr::base
