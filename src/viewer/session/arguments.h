#pragma once

#include <scenes/open_scene.h>

#include <options/camera_options.h>
#include <options/effect_options.h>
#include <options/views/views_plan.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// CLI11's own name. NOLINTNEXTLINE(readability-identifier-naming)
namespace CLI {
class App;
}

namespace cdr::viewer {

/// The command line of cdr-viewer.
struct Arguments {
    std::string scene = "afc";
    bool isFirstUse = false; ///< nothing was asked for: the interface says what can be done
    scene::GltfChoice choice;
    options::CameraOptions camera;
    std::uint64_t seed = scenes::kDefaultSeed;
    std::vector<std::string> layers;           ///< for scenes::parseLayer()
    std::string colours;                       ///< empty: bright, except for a line that renders a picture
    std::string technique;                     ///< of one picture
    std::string compare = "standard,anchored"; ///< "LEFT,RIGHT", unless there is one technique
    std::string depth;                         ///< with `split`, instead of a technique
    std::string split;
    std::string submission = "secondaries";
    std::string batching = "instanced";
    std::string snapping = "by-device";
    std::string detail = "none";
    options::EffectArguments effects;
    options::ViewsArguments views; ///< one eye, or two
    std::string aov = "color";
    std::string output; ///< of a line that renders a picture, which is shown instead; empty without
    std::string targets = "single";
    std::string format;
    std::size_t threads = 1;
    std::string size = "1280x720";
    std::string device;
    bool validate = false;
    bool plays = false;                  ///< the scene's camera path from the start
    bool waitsForDisplay = false;        ///< FIFO instead of mailbox
    std::string unit = "auto";           ///< of lengths
    double uiScale = 0.0;                ///< 0: the display's
    std::optional<std::uint64_t> frames; ///< UI frames after which to quit
    std::filesystem::path screenshot;    ///< of the window, when it quits
    bool statistics = false;             ///< prints frame times when it quits
};

/// Adds the viewer's options to a program, which fills `arguments` when it parses a command line.
void addViewerOptions(CLI::App& program, Arguments& arguments);

/// Parses the command line of cdr-viewer itself, which has no other options. Returns and throws as parse() does.
std::optional<int> parseViewer(int argc, char** argv, Arguments& arguments);

/// Parses a command line. Returns an exit status when the program is done, as after --help.
/// base::InputError for what is wrong with it.
std::optional<int> parse(CLI::App& program, int argc, char** argv);

} // namespace cdr::viewer
