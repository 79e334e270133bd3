#pragma once

#include <cdr/base/quantity_text.h>
#include <viewer/state/view_settings.h>

#include <options/camera_options.h>
#include <options/cli_app.h>
#include <options/drawing_options.h>
#include <options/scene_options.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace cdr::viewer {

/// Reads "LEFT,RIGHT". base::InputError for anything that is not two techniques.
std::array<depth::Technique, 2> parsePair(std::string_view text);

/// Reads "WIDTHxHEIGHT" of a window. base::InputError unless each side is 1 to kMaxWindowSide.
PictureExtent parseWindowSize(std::string_view text);

/// What is compared unless told otherwise, as of --compare.
inline constexpr const char* kCompared = "standard,anchored";

/// The command line of cdr-viewer.
struct Arguments {
    ViewSettings settings{.scene = "afc"}; ///< but for what the members below say
    bool isFirstUse = false;               ///< nothing was asked for: the interface says what can be done
    options::CameraOptions camera;
    options::LayerArguments layers;
    std::optional<scenes::Colours> colours;    ///< else bright, except for a line that renders a picture
    std::optional<depth::Technique> technique; ///< of one picture
    std::optional<std::array<depth::Technique, 2>> compare; ///< left and right; by default kCompared
    options::TechniqueParts parts;                          ///< instead of a technique
    std::optional<depth::DepthFormat> format;
    std::string output; ///< of a line that renders a picture, which is shown instead; empty without
    std::optional<PictureExtent> size; ///< of the window, or of an eye's picture with `output`
    std::string device;
    bool validate = false;
    bool plays = false;                                  ///< the scene's camera path from the start
    bool waitsForDisplay = false;                        ///< FIFO instead of mailbox
    base::LengthUnit unit = base::LengthUnit::automatic; ///< of lengths
    double uiScale = 0.0;                                ///< 0: the display's
    std::optional<std::uint64_t> frames;                 ///< UI frames after which to quit
    std::filesystem::path screenshot;                    ///< of the window, when it quits
    bool statistics = false;                             ///< prints frame times when it quits
};

/// Adds the viewer's options to a program, which fills `arguments` when it parses a command line.
void addViewerOptions(CLI::App& program, Arguments& arguments);

/// Parses the command line of cdr-viewer itself, which has no other options. Returns and throws as parse() does.
std::optional<int> parseViewer(int argc, char** argv, Arguments& arguments);

/// Parses a command line. Returns an exit status when the program is done, as after --help.
/// base::InputError for what is wrong with it.
std::optional<int> parse(CLI::App& program, int argc, char** argv);

} // namespace cdr::viewer
