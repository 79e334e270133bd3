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
    HelpLine{"drag right", "look about, on an orbit too; keys fly meanwhile"},
    HelpLine{"drag middle", "go round what was last clicked; with shift, shift the view"},
    HelpLine{"wheel", "go nearer or farther"},
    HelpLine{"F", "look at what was last clicked so that it fills the picture"},
    HelpLine{"O, double click", "orbit what was last clicked; O flies again"},
    HelpLine{"home", "back to the scene's own camera"},
    HelpLine{"gamepad", "left stick moves, right stick looks, bumpers rise and sink, triggers zoom"},
};

constexpr std::array kLens{
    HelpLine{"alt + wheel", "narrow or widen the lens, 90 to 0.001 degrees, toward the cursor"},
};

constexpr std::array kComparing{
    HelpLine{"1 to 6", "standard, cdr, log, logcdr, reversed, anchored"},
    HelpLine{"shift + 1 to 6", "the same for the right side of a split screen"},
    HelpLine{"C", "split the screen, or join it"},
    HelpLine{"drag the divider", "wipe from one technique to the other"},
    HelpLine{"V",
             "next view: shaded, cascades, distance, ids, wrong pixels, flips; with shift, the one before"},
};

constexpr std::array kEyes{
    HelpLine{"G", "two eyes side by side, then as an anaglyph, then one; with shift, parallel or toed-in"},
};

constexpr std::array kMeasuring{
    HelpLine{"click", "name what is there, its place and distance; a second click measures from the first"},
    HelpLine{"X", "forget both"},
};

constexpr std::array kKeeping{
    HelpLine{"T", "a tour: from a space station's window to a runway's number"},
    HelpLine{"space", "follow the scene's own camera path, or stop"},
    HelpLine{"K", "play a file's animation, or pause; the panel Camera chooses one"},
    HelpLine{"R", "record the camera's path, or end the recording"},
    HelpLine{"P", "play what was recorded"},
    HelpLine{"F11", "record what is shown as a video, both sides beside each other, or end it"},
    HelpLine{"F12", "write the picture to a file; with shift, the whole window"},
    HelpLine{"ctrl + C",
             "copy the command line that renders this picture without a window, or one for each side"},
    HelpLine{"drop a file", "open a .gltf or .glb scene"},
    HelpLine{"tab", "show or hide the panels"},
    HelpLine{"F2 to F6",
             "choose in a panel by arrows, enter and space; esc gives the keys back to the camera"},
    HelpLine{"F1", "show or hide this help"},
    HelpLine{"ctrl + Q", "close the window"},
};

constexpr std::array kSections{
    HelpSection{"Moving", kMoving},       HelpSection{"Lens", kLens},
    HelpSection{"Comparing", kComparing}, HelpSection{"Eyes", kEyes},
    HelpSection{"Measuring", kMeasuring}, HelpSection{"Keeping", kKeeping},
};

} // namespace

std::span<const HelpSection> helpText() {
    return kSections;
}

} // namespace cdr::viewer
