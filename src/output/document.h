#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>

namespace cdr::output {

/// Writes a document whole or not at all, indented; "-" is standard output.
/// InputError or RunError when that fails.
void writeDocument(const std::filesystem::path& path, const nlohmann::ordered_json& document);

} // namespace cdr::output
