#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace cdr::base {

/// Version and commit the binary was built from; the commit is "unknown" outside a git checkout.
struct BuildInfo {
    std::string version;
    std::string commit;
};
BuildInfo buildInfo();

/// What a command's JSON says of the device it ran on. Empty texts for commands that need none.
struct DocumentDevice {
    std::string name;
    std::string driver;
    std::string api;
};

/// The envelope every command's JSON shares: command, version, commit, device, host, options, results
/// (empty).
nlohmann::ordered_json makeDocument(const std::string& command, const DocumentDevice& device,
                                    nlohmann::ordered_json options);

/// Adds a section of its own behind the results, an empty array, for what is not one row per result: pairs of
/// them, fits through them. Not a name of the envelope.
nlohmann::ordered_json& addSection(nlohmann::ordered_json& document, const std::string& name);

/// Writes a document, indented, whole or not at all; "-" is standard output.
void writeDocument(const std::filesystem::path& path, const nlohmann::ordered_json& document);

} // namespace cdr::base
