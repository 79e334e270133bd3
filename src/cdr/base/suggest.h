#pragma once

#include <cdr/base/export.h>
#include <cdr/base/result.h>

#include <span>
#include <string>
#include <string_view>

namespace cdr::base {

/// "unknown WHAT 'GIVEN'; did you mean 'CLOSEST'? (known: a, b, c)". The closest is by edit distance, and
/// left out when nothing is similar.
CDR_EXPORT std::string unknownName(std::string_view what, std::string_view given,
                                   std::span<const std::string_view> known);

/// A finite decimal number. InputError with `what` for anything else.
CDR_EXPORT double parseNumber(std::string_view what, std::string_view text);
/// The same, refused instead of thrown.
CDR_EXPORT Result<double> tryParseNumber(std::string_view what, std::string_view text);

} // namespace cdr::base
