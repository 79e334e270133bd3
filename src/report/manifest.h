#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace cdr::report {

/// The file in a report's folder that says it is one, and lists the files that belong to it.
inline constexpr const char* kManifest = "report.json";

/// The files that a manifest calls its own, itself included: names relative to the report's folder.
/// @param text a file's bytes, which may come from anyone.
/// @return nothing where the text is no manifest of a report, or is nested deeper than one ever is.
std::optional<std::set<std::string>> filesOfManifest(std::string_view text);

} // namespace cdr::report
