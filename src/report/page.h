#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace cdr::report {

/// base::RunError, saying what to do, when this program was built without the page (no npm packages then).
void requirePage();

/// Writes the page's own files, which hold no results: they are in this program.
void writePage(const std::filesystem::path& folder);

/// Writes the results as a script, since a page opened from a file may not read other files.
void writeData(const std::filesystem::path& folder, const nlohmann::ordered_json& data);

} // namespace cdr::report
