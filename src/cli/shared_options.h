#pragma once

#include <CLI/CLI.hpp>
#include <cdr/base/quantity_text.h>
#include <cdr/depth/technique.h>

#include <nlohmann/json_fwd.hpp>
#include <options/camera_options.h>
#include <options/drawing_options.h>
#include <options/effect_options.h>
#include <options/parsed_option.h>
#include <options/scene_options.h>
#include <ranks/ranks.h>
#include <rivals/rival.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cdr::cli {

/// `--device each`: the ranks of a machine take its devices in turn.
inline constexpr const char* kEachDevice = "each";

/// Options that stand before the command.
struct GlobalOptions {
    std::string device; ///< index or part of a name, empty for the best; or kEachDevice
    bool validate = false;
    bool quiet = false;
    bool shareMachine = false; ///< time though other ranks of the run keep the same machine busy
    bool bind = false;         ///< keep this rank's threads on its part of the machine's processors
    std::size_t hostCpus =
        0; ///< what JSON says of the machine where this process, as a rank, may be bound to fewer; else 0
    std::optional<std::uint64_t> textureMiB; ///< as scene::GltfChoice has it
    std::optional<double> pointRadius;       ///< as scene::GltfChoice has it
    std::optional<base::LengthUnit> unit;    ///< of lengths in tables and sentences; none by default
    ranks::Run* ranks = nullptr;             ///< of the process; main() fills it in
    std::string section; ///< of a report that the command runs for: only its progress shows, under this name
};

/// What every command takes.
struct OutputOptions {
    std::optional<std::filesystem::path> json; ///< "-" is standard output
};

/// Most frames one call renders.
using options::kMaxFrames;

using options::kMaxTranslucencyMiB;

using options::addList;
using options::addSeed;
using options::addSnapBits;
using options::addSnapping;
using options::addThreads;
using options::addValue;
using options::requireDistinct;

// Each adds an option; what it refers to must live as long as the command.

/// `--json [FILE]`; without a file, or with "-", JSON goes to standard output and the table to standard error.
/// base::InputError for a file that is named as a scene.
void addJson(CLI::App& command, OutputOptions& output);

/// `--distances A,B,...`, in scene units.
void addDistances(CLI::App& command, std::vector<double>& distancesView);
/// `--csv FILE`.
void addCsv(CLI::App& command, std::filesystem::path& file);
/// `--plot FILE`.
/// @param what the plot shows, for the help.
void addPlot(CLI::App& command, std::filesystem::path& file, const std::string& what);
/// `--trace FILE`.
/// @param what the trace shows, for the help.
void addTrace(CLI::App& command, std::filesystem::path& file, const std::string& what);

/// What help says of a list of depth formats.
inline constexpr const char* kFormatsHelp = "Depth formats to compare, separated by commas: d16, d24, d32f";
/// What help says of --repeats.
inline constexpr const char* kRepeatsHelp = "Timed frames per measurement";
/// What help says of --state.
inline constexpr const char* kStateHelp =
    "Keep finished results in FILE, so that the same command continues an interrupted run";
/// `--state FILE`, for Command::keepUnits().
void addState(CLI::App& command, std::filesystem::path& state);

/// All options that were given, in words, except where JSON and the state go. It identifies the run that a state belongs to.
std::string textOf(const CLI::App& command);
/// Options that were given and what was given, as words by name, for JSON. Without those that say
/// where results go, or how ranks divide the work.
nlohmann::ordered_json givenOptions(const CLI::App& command);

/// `--size WIDTHxHEIGHT`. base::InputError for anything that is not two whole numbers above 0.
void addSize(CLI::App& command, std::uint32_t& width, std::uint32_t& height);

/// `--frames`, 1 to `most`.
void addFrames(CLI::App& command, std::uint32_t& frames, const std::string& help,
               std::uint32_t most = kMaxFrames);

/// `--techniques A,B,...` instead of those that are there. Without the option, most commands take all presets.
/// base::InputError as options::requireDistinct().
CLI::Option* addTechniques(CLI::App& command, std::vector<depth::NamedTechnique>& techniques);

/// `--rivals A,B,...`. base::InputError as options::requireDistinct().
/// @param otherwise which there are where none are listed, for the help.
void addRivalList(CLI::App& command, std::vector<rivals::NamedRival>& chosen, const std::string& otherwise);

} // namespace cdr::cli
