#pragma once

#include <viewer/window/input_event.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace cdr::viewer {

// What a script can ask for besides input. One of these or an input event stands on each line.

struct ClickItem {
    std::string name;        ///< as ItemPlaces knows it
    bool isRevealed = false; ///< its panel has been scrolled for it
};
/// Presses and releases the left button before the next frame of the interface.
struct Tap {};
struct WindowSize {
    int width = 0;
    int height = 0;
};
/// Waits until what was asked for is on the screen, and then for so many results more. Ends where nothing changes.
struct WaitFrame {
    std::uint64_t more = 0;
};
struct WaitUi {
    std::uint64_t frames = 1;
};
struct SaveWindow {
    std::filesystem::path file;
};
struct SavePicture {
    std::filesystem::path file;
};
/// Prints where an item is, or what the viewer shows.
struct PrintPlace {
    std::string name;
};
struct PrintState {};
/// Prints the `cdr render` line of what is shown.
struct PrintCommand {};
/// Waits until what `state` prints contains a text.
struct WaitState {
    std::string text;
};
struct Minimise {};
struct Restore {};
struct Quit {};

using ScriptStep =
    std::variant<InputEvent, ClickItem, Tap, WindowSize, WaitFrame, WaitUi, SaveWindow, SavePicture,
                 PrintPlace, PrintState, PrintCommand, WaitState, Minimise, Restore, Quit>;

/// Reads a script, one step a line; empty lines and those that begin with # are left out.
///
///     key NAME [shift] [control]   presses and releases: a letter, a digit, F1 to F12, tab, space, home, ...
///     hold NAME, let NAME          presses, releases
///     move X Y, press [B], release [B], scroll N
///     click NAME                   the interface's item of that name, scrolled into view where it is not
///     type TEXT                    its letters, into what has the keyboard
///     drop FILE, drop-all FILE... (names without spaces), resize W H, minimise, restore
///     wait-frame [N], wait-ui N, window FILE, picture FILE, where NAME, state, quit
///                                  wait-frame also ends if nothing changes any more
///     wait-state TEXT              until the line that `state` prints holds it
///     command                      prints the command line that renders the picture without a window
///
/// base::InputError, naming the line, for anything else.
std::vector<ScriptStep> parseScript(const std::string& text, const std::string& name);

/// parseScript() of a file's text. base::InputError when it cannot be read.
std::vector<ScriptStep> readScript(const std::filesystem::path& file);

} // namespace cdr::viewer
