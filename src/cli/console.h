#pragma once

#include "session.h"

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace cdr::cli {

/// Where a command's table goes: standard output, or standard error when that carries JSON, or nowhere when
/// quiet.
class Console {
  public:
    Console(const GlobalOptions& global, const OutputOptions& output);

    void line(const std::string& text) const;
    /// Rows of cells under a header, columns aligned, numbers to the right by the caller's formatting.
    void table(const std::vector<std::string>& header,
               const std::vector<std::vector<std::string>>& rows) const;

    /// A counter with the time left, on standard error and only where that is a terminal.
    void progress(std::size_t done, std::size_t all, const std::string& what) const;
    /// Takes the counter away.
    void endProgress() const;

  private:
    bool m_toError;
    bool m_quiet; ///< no lines and tables
    bool m_showsProgress;
    std::string m_section; ///< of a report, in front of the progress; else empty
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// Writes the document where --json asks for it.
void writeJson(const OutputOptions& output, const nlohmann::ordered_json& document);

} // namespace cdr::cli
