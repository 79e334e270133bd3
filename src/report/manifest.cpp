#include "manifest.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace cdr::report {

namespace {

using nlohmann::json;

/// More than a manifest needs. Deep nesting would take eighty times the file's size in memory.
constexpr int kDeepest = 16;

/// Null where the text is no JSON or too deeply nested.
json shallowJson(std::string_view text) {
    bool isTooDeep = false;
    const auto keep = [&](int depth, json::parse_event_t, json&) {
        isTooDeep = isTooDeep || depth > kDeepest;
        return !isTooDeep;
    };
    json parsed = json::parse(text, keep, false);
    return isTooDeep ? json() : std::move(parsed);
}

} // namespace

std::optional<std::set<std::string>> filesOfManifest(std::string_view text) {
    const json manifest = shallowJson(text);
    if (!manifest.is_object() || manifest.value("command", json()) != "report") {
        return std::nullopt;
    }
    const auto listed = manifest.find("files");
    if (listed == manifest.end() || !listed->is_array()) {
        return std::nullopt;
    }
    std::set<std::string> files{kManifest};
    for (const json& file : *listed) {
        if (file.is_string()) {
            files.insert(file.get<std::string>());
        }
    }
    return files;
}

} // namespace cdr::report
