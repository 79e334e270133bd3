#include "manifest.h"

#include <cdr/platform/json_text.h>

#include <nlohmann/json.hpp>

namespace cdr::report {

namespace {

using nlohmann::json;

/// Null where the text is no JSON or too deeply nested.
json manifestIn(std::string_view text) {
    constexpr int kDeepest = 16; // more than a manifest needs
    try {
        return platform::parseShallow<json>(text, kDeepest, "is no manifest");
    } catch (const base::InputError&) {
    } catch (const json::exception&) {
    }
    return {};
}

} // namespace

std::optional<std::set<std::string>> filesOfManifest(std::string_view text) {
    const json manifest = manifestIn(text);
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
