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

/// A section as the plan has it.
struct PlanRow {
    std::string name;    ///< of the section
    std::string command; ///< with its positional arguments as options without a name
    std::vector<PlanOption> options{};
    std::string folderOption{}; ///< as Section has both
    std::string folder{};
    bool isTimed = false;      ///< whether what it is about is time
    double quickSeconds = 0.0; ///< the smallest effort takes a fiftieth
    double fullSeconds = 0.0;
};

/// Values that PlanOptions hold.
inline constexpr const char* kThreads = "{threads}";
inline constexpr const char* kSeed = "{seed}";

/// The sections of a report, in the order of the page.
const std::vector<PlanRow>& planTable();

} // namespace cdr::report
