#pragma once

#include <string>
#include <vector>

namespace cdr::report {

/// The option of videos, which need an encoder.
inline constexpr const char* kVideos = "--videos";

/// An option of a command, and its value at each effort, smallest first; one value holds for all, and none makes a
/// flag. An empty value leaves the option out.
struct PlanOption {
    std::string name;
    std::vector<std::string> values{};
};

/// What a section takes.
struct PlanSeconds {
    double quick = 0.0; ///< the smallest effort takes a fiftieth
    double full = 0.0;
};

/// Where a section's files go, as Section has it.
struct PlanOut {
    std::string option{};
    std::string folder{};
};

/// A section as the plan has it.
struct PlanRow {
    std::string name;      ///< of the section
    std::string command{}; ///< else named as the section; positional arguments are options without a name
    std::vector<PlanOption> options{};
    PlanOut out{};
    bool isTimed = false; ///< whether what it is about is time
    PlanSeconds seconds{};
};

/// Values that PlanOptions hold.
inline constexpr const char* kThreads = "{threads}";
inline constexpr const char* kSeed = "{seed}";

/// The sections of a report, in the order of the page.
const std::vector<PlanRow>& planTable();

} // namespace cdr::report
