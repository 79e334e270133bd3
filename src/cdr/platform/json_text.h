#pragma once

#include <cdr/base/error.h>

#include <nlohmann/json.hpp>

#include <string>

namespace cdr::platform {

/// JSON as text with a final line break. Bytes of texts that are not UTF-8, as file names may hold, become
/// U+FFFD.
/// @param indent spaces a level; -1 for one line.
std::string textOf(const nlohmann::ordered_json& json, int indent);

/// The JSON of a text. Deep nesting would take eighty times the text's size in memory, and a writer of JSON goes down it by calls.
/// Json::exception for what is no JSON, base::InputError that says `tooDeep` for values nested deeper than `deepest`.
template <typename Json, typename Text>
Json parseShallow(const Text& text, int deepest, const char* tooDeep) {
    const auto isShallow = [&](int depth, typename Json::parse_event_t, const Json&) {
        if (depth > deepest) {
            throw base::InputError(tooDeep);
        }
        return true;
    };
    return Json::parse(text, isShallow);
}

} // namespace cdr::platform
