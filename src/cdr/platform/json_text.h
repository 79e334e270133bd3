#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace cdr::platform {

/// JSON as text with a final line break. Bytes of texts that are not UTF-8, as file names may hold, become
/// U+FFFD.
/// @param indent spaces a level; -1 for one line.
std::string textOf(const nlohmann::ordered_json& json, int indent);

} // namespace cdr::platform
