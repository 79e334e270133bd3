#include "command.h"
#include "commands.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/process.h>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace cdr::cli {

namespace {

namespace fs = std::filesystem;

/// cdr-viewer beside this program; else the one that PATH finds.
std::string viewerProgram() {
    if (const std::optional<fs::path> own = platform::ownProgram()) {
        std::error_code error;
        const fs::path beside = own->parent_path() / "cdr-viewer";
        if (fs::exists(beside, error)) {
            return beside.string();
        }
    }
    return "cdr-viewer";
}

/// Becomes the viewer. base::InputError where there is none.
[[noreturn]] void becomeViewer(std::vector<std::string> arguments, const GlobalOptions& global) {
    const auto refuse = [](bool isGiven, const char* option) {
        if (isGiven) {
            throw base::inputError("cdr view has no option {}", option);
        }
    };
    refuse(global.quiet, "--quiet");
    refuse(global.shareMachine, "--share-machine");
    refuse(global.bind, "--bind");
    if (!global.device.empty()) {
        arguments.insert(arguments.begin(), "--device=" + global.device);
    }
    if (global.validate) {
        arguments.insert(arguments.begin(), "--validate");
    }
    if (global.unit) {
        arguments.insert(arguments.begin(), fmt::format("--unit={}", nameOf(*global.unit)));
    }
    if (global.textureMiB) {
        arguments.insert(arguments.begin(), fmt::format("--texture-memory={}", *global.textureMiB));
    }
    if (global.pointRadius) {
        arguments.insert(arguments.begin(), fmt::format("--points={}", *global.pointRadius));
    }
    arguments.insert(arguments.begin(), viewerProgram());
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    ::execvp(pointers.front(), pointers.data());
    throw base::inputError("{}: cannot be started: {}", arguments.front(),
                           std::generic_category().message(errno));
}

} // namespace

void addView(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "view", "Show a scene in a window: starts cdr-viewer with the arguments that follow");
    app->prefix_command();
    app->fallthrough(false);
    app->set_help_flag(); // what follows is the viewer's, --help too
    app->callback([app, &global] {
        requireAlone(*global.ranks, "view");
        becomeViewer(app->remaining(), global);
    });
}

} // namespace cdr::cli
