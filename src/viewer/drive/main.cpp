#include "script_player.h"
#include "soak.h"

#include <CLI/CLI.hpp>
#include <cdr/base/format_error.h>
#include <cdr/platform/standard_streams.h>
#include <scenes/open_scene.h>
#include <viewer/session/program.h>

#include <options/number_checks.h>
#include <options/parsed_option.h>
#include <program/allocator.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

namespace {

constexpr double kMaxSoakSeconds = 86'400.0;
/// Percent by which memory may grow in a soak. The memory of one of less than a minute says nothing.
constexpr double kLargestGrowth = 1.0;
constexpr double kShortSoakSeconds = 60.0;
constexpr double kMaxGrowth = 1e6;

/// What is asked of this program beyond the viewer's own options.
struct DriveArguments {
    Arguments viewer;
    std::optional<std::filesystem::path> script;
    std::optional<double> soakSeconds;
    std::optional<PictureExtent> largest; ///< window of a soak
    std::vector<std::string> soakScenes;
    std::optional<double> largestGrowth; ///< in percent
};

void addDriveOptions(CLI::App& program, DriveArguments& arguments) {
    CLI::Option* script =
        options::addFile(program, "--script", arguments.script, "Play input from FILE, one step per line");
    CLI::Option* soak =
        program
            .add_option("--soak", arguments.soakSeconds,
                        "Play this many seconds of random input as fast as possible, and quit")
            ->check(options::numberFrom(1.0, kMaxSoakSeconds))
            ->excludes(script);
    options::addParsed(program, "--largest", arguments.largest, parseWindowSize,
                       "Largest window of --soak in pixels")
        ->type_name("WIDTHxHEIGHT")
        ->default_str("1920x1080")
        ->needs(soak);
    const auto generated = scenes::generatedScenes();
    program
        .add_option("--soak-scenes", arguments.soakScenes,
                    "Generated scenes that --soak chooses from, separated by commas")
        ->default_str("cubes,afc,rotation,mixed")
        ->delimiter(',')
        ->check(CLI::IsMember(std::vector<std::string>(generated.begin(), generated.end())))
        ->needs(soak);
    program
        .add_option("--largest-growth", arguments.largestGrowth,
                    "Exit with status 1 if --soak grows memory by more than this many percent")
        ->default_str("1, or no limit for less than a minute")
        ->check(options::numberFrom(-100.0, kMaxGrowth))
        ->needs(soak);
}

/// base::RunError when memory grew by more than it may.
void requireSteadyMemory(const Soak& soak, const DriveArguments& arguments) {
    const bool isShort = *arguments.soakSeconds < kShortSoakSeconds;
    const double most = arguments.largestGrowth.value_or(isShort ? kMaxGrowth : kLargestGrowth);
    if (const auto growth = soak.growth(); growth && *growth > most) {
        throw base::runError("memory grew by {:.2f} % in the soak, where {:.2f} % is allowed", *growth, most);
    }
}

void run(const DriveArguments& arguments) {
    if (arguments.soakSeconds) {
        program::keepFreeMemoryLow();
        program::writeAllBlocks();
        SoakOptions input{.seed = arguments.viewer.settings.seed};
        if (arguments.largest) {
            input.largest = *arguments.largest;
        }
        if (!arguments.soakScenes.empty()) {
            input.scenes = arguments.soakScenes;
        }
        Soak soak(*arguments.soakSeconds, input);
        runViewer(arguments.viewer, &soak);
        platform::printOutput(soak.report() + "\n");
        requireSteadyMemory(soak, arguments);
    } else if (arguments.script) {
        ScriptPlayer player(readScript(*arguments.script));
        runViewer(arguments.viewer, &player);
    } else {
        runViewer(arguments.viewer);
    }
}

int runDriveProgram(int argc, char** argv) {
    return exitStatusOf("cdr-viewer-drive", [&] {
        DriveArguments arguments;
        CLI::App program("The viewer, played by a script or by random input instead of a person: for tests.",
                         "cdr-viewer-drive");
        addViewerOptions(program, arguments.viewer);
        addDriveOptions(program, arguments);
        if (const auto status = parse(program, argc, argv)) {
            return *status;
        }
        run(arguments);
        return 0;
    });
}

} // namespace

} // namespace cdr::viewer

int main(int argc, char** argv) {
    return cdr::viewer::runDriveProgram(argc, argv);
}
