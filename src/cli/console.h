#pragma once

#include "shared_options.h"

#include <fmt/format.h>
#include <output/columns.h>

#include <cstddef>
#include <optional>
#include <string>

namespace cdr::cli {

/// "42 s", "3 min 20 s", "2 h 5 min".
std::string timeText(double seconds);

/// Where a command's table goes: standard output, or standard error when that carries JSON, or nowhere when
/// quiet.
class Console {
  public:
    Console(const GlobalOptions& global, const OutputOptions& output);

    void line(const std::string& text) const;
    /// A line that is shown even when quiet, then on standard error.
    void warning(const std::string& text) const;
    /// Columns aligned: the first to the left, all others to the right.
    void table(const output::Table& table) const;

    /// A counter with the time left if it is known, on standard error and only where that is a terminal.
    void progress(std::size_t done, std::size_t all, const std::string& what,
                  std::optional<double> secondsLeft) const;
    /// Takes the counter away.
    void endProgress() const;

  private:
    bool m_toError;
    bool m_isSilent; ///< not even warnings: the first rank has them
    bool m_quiet;    ///< no lines and tables
    bool m_showsProgress;
    std::string m_section; ///< of a report, in front of the progress; else empty
};

} // namespace cdr::cli
