#include "help_text.h"

#include <array>

namespace cdr::viewer {

namespace {

constexpr std::array kMoving{
    HelpLine{"W S, up down",
             "fly ahead and back, a share of the way to what you look at: you never fly through it"},
    HelpLine{"A D, left right", "fly sideways"},
    HelpLine{"E Q, page up down", "rise and sink in the picture"},
    HelpLine{"shift, ctrl", "eight times faster, eight times slower"},
    HelpLine{"drag left", "look about; on an orbit, turn the scene"},
    HelpLine{"drag right or middle", "on an orbit, shift the view"},
    HelpLine{"O", "orbit what was last clicked, or fly again"},
    HelpLine{"home", "back to the scene's own camera"},
    HelpLine{"gamepad", "left stick moves, right stick looks, bumpers rise and sink, triggers zoom"},
};

constexpr std::array kLens{
    HelpLine{"wheel", "narrow or widen the lens, 90 to 0.001 degrees, toward the cursor"},
    HelpLine{"ctrl + wheel", "on an orbit, go nearer or farther instead"},
};

constexpr std::array kComparing{
    HelpLine{"1 to 6", "standard, cdr, log, logcdr, reversed, anchored"},
    HelpLine{"shift + 1 to 6", "the same for the right side of a split screen"},
    HelpLine{"C", "split the screen, or join it"},
    HelpLine{"drag the divider", "wipe from one technique to the other"},
    HelpLine{"V", "next view: shaded, cascades, distance, ids, wrong pixels, flips"},
};

constexpr std::array kMeasuring{
    HelpLine{"click", "name what is there, its place and distance; a second click measures from the first"},
    HelpLine{"X", "forget both"},
};

constexpr std::array kKeeping{
    HelpLine{"space", "follow the scene's own camera path, or stop"},
    HelpLine{"R", "record the camera's path, or end the recording"},
    HelpLine{"P", "play what was recorded"},
    HelpLine{"F12", "write the picture to a file; with shift, the whole window"},
    HelpLine{"ctrl + C",
             "copy the command line that renders this picture without a window, or one for each side"},
    HelpLine{"drop a file", "open a .gltf or .glb scene"},
    HelpLine{"tab", "show or hide the panels"},
    HelpLine{"F1", "show or hide this help"},
};

constexpr std::array kSections{
    HelpSection{"Moving", kMoving},       HelpSection{"Lens", kLens},
    HelpSection{"Comparing", kComparing}, HelpSection{"Measuring", kMeasuring},
    HelpSection{"Keeping", kKeeping},
};

} // namespace

std::span<const HelpSection> helpText() {
    return kSections;
}

} // namespace cdr::viewer
