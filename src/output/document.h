#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace cdr::output {

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

/// Writes a document whole or not at all, indented; "-" is standard output.
/// InputError or RunError when that fails.
void writeDocument(const std::filesystem::path& path, const nlohmann::ordered_json& document);

} // namespace cdr::output
