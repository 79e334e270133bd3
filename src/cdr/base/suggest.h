#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cdr::base {

/// "unknown WHAT 'GIVEN'; did you mean 'CLOSEST'? (known: a, b, c)", the closest by edit distance, left out
/// when nothing is near.
std::string unknownName(std::string_view what, std::string_view given,
                        std::span<const std::string_view> known);

/// Finite decimal number or InputError naming `what`.
double parseNumber(std::string_view what, const std::string& text);

} // namespace cdr::base
