#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace cdr::host {

/// Version and commit the binary was built from; the commit is "unknown" outside a git checkout.
struct BuildInfo {
    std::string version;
    std::string commit;
};
BuildInfo buildInfo();

/// The device that a command ran on, for its JSON. Empty texts for commands that need none.
struct DocumentDevice {
    std::string name;
    std::string driver;
    std::string api;
};

/// What the JSON of every command begins with: command, version, commit, device, host, options and empty
/// results.
nlohmann::ordered_json makeDocument(const std::string& command, const DocumentDevice& device,
                                    nlohmann::ordered_json options);

/// JSON as text with a final line break. Bytes of texts that are not UTF-8, as file names may hold, become
/// U+FFFD.
/// @param indent spaces a level; -1 for one line.
std::string textOf(const nlohmann::ordered_json& json, int indent);

/// Writes a document whole or not at all, indented; "-" is standard output.
/// InputError or RunError when that fails.
void writeDocument(const std::filesystem::path& path, const nlohmann::ordered_json& document);

} // namespace cdr::host
