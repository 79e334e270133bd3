#include "console.h"

#include <cdr/platform/file.h>
#include <cdr/platform/standard_streams.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace cdr::cli {

namespace {

enum class Stream : std::uint8_t { output, error };

void print(const std::string& text, Stream stream) {
    if (stream == Stream::error) {
        platform::printError(text);
    } else {
        platform::printOutput(text + "\n");
    }
}

} // namespace

Console::Console(const GlobalOptions& global, const OutputOptions& output)
    : m_toError(output.json == "-"),
      m_isSilent(!global.ranks->isFirst()),
      m_quiet(m_isSilent || global.quiet || !global.section.empty()),
      m_showsProgress(!m_isSilent && !global.quiet && ::isatty(STDERR_FILENO) != 0),
      m_section(global.section.empty() ? "" : global.section + ": ") {}

void Console::line(const std::string& text) const {
    if (!m_quiet) {
        print(text, m_toError ? Stream::error : Stream::output);
    }
}

void Console::warning(const std::string& text) const {
    if (!m_isSilent) {
        print(text, m_quiet || m_toError ? Stream::error : Stream::output);
    }
}

void Console::table(const output::Table& table) const {
    std::vector<std::size_t> widths;
    for (const std::string& cell : table.header) {
        widths.push_back(cell.size());
    }
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], row[i].size());
        }
    }
    const auto print = [&](const std::vector<std::string>& row) {
        std::string text;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string cell = platform::oneLine(row[i]); // of a file's name, too
            // Names to the left, figures to the right.
            text +=
                i == 0 ? fmt::format("{:<{}}", cell, widths[i]) : fmt::format("  {:>{}}", cell, widths[i]);
        }
        line(text);
    };
    print(table.header);
    for (const auto& row : table.rows) {
        print(row);
    }
}

std::string timeText(double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::llround(seconds));
    if (whole < 60) {
        return fmt::format("{} s", whole);
    }
    return whole < 3600 ? fmt::format("{} min {} s", whole / 60, whole % 60)
                        : fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

void Console::progress(std::size_t done, std::size_t all, const std::string& what,
                       std::optional<double> secondsLeft) const {
    if (!m_showsProgress || all == 0) {
        return;
    }
    const std::string left = secondsLeft ? ", " + timeText(*secondsLeft) + " left" : "";
    fmt::print(stderr, "\r\x1b[K{}{}/{} {}{}", m_section, done, all, platform::oneLine(what), left);
    std::fflush(stderr);
}

void Console::endProgress() const {
    if (m_showsProgress) {
        fmt::print(stderr, "\r\x1b[K");
    }
}

} // namespace cdr::cli
