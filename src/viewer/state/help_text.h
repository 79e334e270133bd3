#pragma once

#include <span>
#include <string_view>

namespace cdr::viewer {

/// A key, or what the mouse does, and what comes of it.
struct HelpLine {
    std::string_view keys;
    std::string_view meaning;
};

struct HelpSection {
    std::string_view title;
    std::span<const HelpLine> lines;
};

/// What F1 shows.
std::span<const HelpSection> helpText();

} // namespace cdr::viewer
