#pragma once

#include <cdr/base/enum_names.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::report {

/// How much a report measures.
enum class Effort : std::uint8_t {
    smallest, ///< as little as fills a page: for its tests
    quick,    ///< a few frames of each experiment: under five minutes on two unloaded cores
    full,     ///< the thesis' own numbers of frames: hours
};

inline constexpr base::EnumNames<Effort, 3> kEfforts{"effort", {"smallest", "quick", "full"}};

/// One experiment of a report: a command of this program and where its results go.
struct Section {
    std::string name;                   ///< of the section and of its JSON, such as "probe"
    std::vector<std::string> arguments; ///< as typed, without where its results go
    std::string folderOption{};         ///< such as "--out"; empty when JSON is all it writes
    std::string folder{};               ///< that the option takes, or one file: "inspect.png"
    bool isTimed = false;               ///< measures time, so that nothing else may run meanwhile
    double expectedSeconds = 0.0;       ///< where cli::measuredPace() gives 1

    /// The whole command, the program's name left out, with its results under `root`.
    std::vector<std::string> commandIn(const std::filesystem::path& root) const;
    /// Where its JSON goes, relative to the report.
    std::filesystem::path jsonFile() const;
};

/// What a report measures.
struct PlanOptions {
    Effort effort = Effort::quick;
    bool videos = true;      ///< false where ffmpeg is missing
    std::size_t threads = 1; ///< that cull, bin, record and cast the truth
    std::uint64_t seed = 2013;
    /// A section's name, or the part of it that several share: "shadows-orbit", "shadows". Empty for all.
    std::vector<std::string> sections{};
};

/// The sections, in the order of the page. Those that measure time run last, when nothing else does.
/// @throws base::InputError where a name is no section's.
std::vector<Section> makePlan(const PlanOptions& options);

/// The command as one would type it, in the report's folder.
/// @param device of --device; empty for the best.
std::string commandLine(const Section& section, std::string_view device);
/// The same of the whole report.
std::string commandLine(const PlanOptions& options, std::string_view device);

} // namespace cdr::report
