#pragma once

#include <cdr/base/export.h>
#include <cdr/base/result.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cdr::base {

/// The known name that is nearest to one that is given, by edit distance; none where nothing is similar.
/// @errors None.
std::optional<std::string_view> nearestName(std::string_view given, std::span<const std::string_view> known);

/// "unknown WHAT 'GIVEN'; did you mean 'CLOSEST'? (known: a, b, c)". The closest is by edit distance, and
/// left out when nothing is similar.
/// @errors None.
CDR_EXPORT std::string unknownName(std::string_view what, std::string_view given,
                                   std::span<const std::string_view> known);

/// A finite decimal number, in the unit that its text is in.
/// @throws InputError that names `what` for anything else.
CDR_EXPORT double parseNumber(std::string_view what, std::string_view text);
/// parseNumber() in the same unit, refused instead of thrown.
/// @errors None.
Result<double> tryParseNumber(std::string_view what, std::string_view text);

} // namespace cdr::base
