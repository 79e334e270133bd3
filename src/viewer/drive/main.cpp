#include "allocator.h"
#include "script_player.h"
#include "soak.h"

#include <CLI/CLI.hpp>
#include <cdr/host/standard_streams.h>
#include <experiments/number_checks.h>
#include <scenes/open_scene.h>
#include <viewer/session/program.h>
#include <viewer/session/startup.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace viewer = cdr::viewer;

constexpr double kMaxSoakSeconds = 86'400.0;

/// What is asked of this program beyond the viewer's own options.
struct DriveArguments {
    viewer::Arguments viewer;
    std::optional<std::filesystem::path> script;
    std::optional<double> soakSeconds;
    std::optional<std::string> largest; ///< window of a soak
    std::vector<std::string> soakScenes;
};

void addDriveOptions(CLI::App& program, DriveArguments& arguments) {
    CLI::Option* script =
        program.add_option("--script", arguments.script, "Play input from FILE, one step a line");
    CLI::Option* soak =
        program
            .add_option("--soak", arguments.soakSeconds,
                        "Play random input worth so many seconds, as fast as frames come, and quit")
            ->check(cdr::experiments::numberFrom(1.0, kMaxSoakSeconds))
            ->excludes(script);
    program
        .add_option("--largest", arguments.largest,
                    "WIDTHxHEIGHT of the largest window of a soak, 1920x1080 unless told")
        ->needs(soak);
    const auto generated = cdr::scenes::generatedScenes();
    program
        .add_option(
            "--soak-scenes", arguments.soakScenes,
            "Generated scenes that a soak chooses from, with commas between; cubes,afc,rotation,mixed unless told")
        ->delimiter(',')
        ->check(CLI::IsMember(std::vector<std::string>(generated.begin(), generated.end())))
        ->needs(soak);
}

void run(const DriveArguments& arguments) {
    if (arguments.soakSeconds) {
        viewer::keepFreeMemoryLow();
        viewer::SoakOptions input{.seed = arguments.viewer.seed};
        if (arguments.largest) {
            viewer::Arguments window;
            window.size = *arguments.largest;
            input.largest = viewer::windowSize(window);
        }
        if (!arguments.soakScenes.empty()) {
            input.scenes = arguments.soakScenes;
        }
        viewer::Soak soak(*arguments.soakSeconds, input);
        viewer::runViewer(arguments.viewer, &soak);
        cdr::host::printOutput(soak.report() + "\n");
    } else if (arguments.script) {
        viewer::ScriptPlayer player(viewer::readScript(*arguments.script));
        viewer::runViewer(arguments.viewer, &player);
    } else {
        viewer::runViewer(arguments.viewer);
    }
}

} // namespace

int main(int argc, char** argv) {
    return viewer::exitStatusOf("cdr-viewer-drive", [&] {
        DriveArguments arguments;
        CLI::App program("The viewer, driven by a script or by random input instead of a person: for tests.",
                         "cdr-viewer-drive");
        viewer::addViewerOptions(program, arguments.viewer);
        addDriveOptions(program, arguments);
        if (const auto status = viewer::parse(program, argc, argv)) {
            return *status;
        }
        run(arguments);
        return 0;
    });
}
