#include "shortcuts.h"

#include <cdr/gpu/vulkan_hpp.h>
#include <viewer/state/camera/stereo_view.h>

#include <GLFW/glfw3.h>

#include <array>
#include <utility>

namespace cdr::viewer {

namespace {

void toggleComparison(ViewerModel& model, const Pressed&) {
    compareTwo(model.settings, !model.settings.second.has_value());
}

void stepView(ViewerModel& model, const Pressed& pressed) {
    const auto now = static_cast<std::size_t>(model.settings.view);
    const std::size_t steps = pressed.shift ? kViewKinds.size() - 1 : 1;
    model.settings.view = kViewKinds[(now + steps) % kViewKinds.size()];
}

void toggleScenePath(ViewerModel& model, const Pressed&) {
    togglePath(model.camera);
}

void toggleAnimation(ViewerModel& model, const Pressed&) {
    Playback& playback = model.camera.playback;
    const bool isOpen =
        model.picture.shown != nullptr && model.picture.shown->sceneName == model.settings.scene;
    if (!isOpen || model.picture.shown->scene->animations.empty()) {
        playback.isPlaying = !playback.isPlaying; // of what is being opened
        return;
    }
    const scene::OpenedScene& scene = *model.picture.shown->scene;
    if (!model.settings.choice.framesPerSecond) {
        model.settings.choice = withAnimation(model.settings.choice, scene, 0);
        playback.seconds = 0.0; // not where another file's was paused
    }
    playback.toggle(playableSeconds(model.settings.choice, scene));
}

void togglePanels(ViewerModel& model, const Pressed&) {
    model.interface.showsPanel = !model.interface.showsPanel;
}

void toggleHelp(ViewerModel& model, const Pressed&) {
    model.interface.showsHelp = !model.interface.showsHelp;
}

void takeScreenshot(ViewerModel& model, const Pressed& pressed) {
    model.actions.push_back(pressed.shift ? Action::screenshotWindow : Action::screenshotPicture);
}

void showPanel(ViewerModel& model, const Pressed& pressed) {
    model.interface.panelKeys = PanelKeys{.panel = pressed.place};
    model.interface.showsPanel = true;
}

void choosePreset(ViewerModel& model, const Pressed& pressed) {
    const std::size_t side = pressed.shift && model.settings.second ? 1 : 0;
    model.settings = withPreset(model.settings, side, pressed.place + 1);
}

void toggleOrbit(ViewerModel& model, const Pressed&) {
    if (model.camera.orbits) {
        model.camera.orbits = false;
    } else {
        beginOrbit(model.camera, model.picture.measuring);
    }
}

void chooseEyes(ViewerModel& model, const Pressed& pressed) {
    const LookedAt at{.surfaceView = model.camera.surfaceView, .fovY = model.camera.now.fovY};
    model.settings = pressed.shift ? withOtherEyes(std::move(model.settings), at)
                                   : withNextStereo(std::move(model.settings), at);
}

/// Gives the keys of a panel back, or else closes what lies over the picture.
void escape(ViewerModel& model) {
    if (model.interface.panelKeys) {
        model.interface.panelKeys.reset();
    } else {
        model.interface.showsHelp = false;
        model.interface.firstSteps.end();
    }
}

template <Action Chosen>
void take(ViewerModel& model, const Pressed&) {
    model.actions.push_back(Chosen);
}

constexpr std::array kMoving{
    Shortcut{"W S, up down",
             "fly ahead and back, a share of the way to what you look at: you never fly through it"},
    Shortcut{"A D, left right", "fly sideways"},
    Shortcut{"E Q, page up down", "rise and sink in the picture"},
    Shortcut{"shift, ctrl", "eight times faster, eight times slower"},
    Shortcut{"drag left", "look about; on an orbit, turn the scene"},
    Shortcut{"drag right", "look about, on an orbit too; keys fly meanwhile"},
    Shortcut{"drag middle", "go round what was last clicked; with shift, shift the view"},
    Shortcut{"wheel", "go nearer or farther"},
    Shortcut{"F", "look at what was last clicked so that it fills the picture", take<Action::frameSelected>,
             GLFW_KEY_F},
    Shortcut{"O, double click", "orbit what was last clicked; O flies again", toggleOrbit, GLFW_KEY_O},
    Shortcut{"home", "back to the scene's own camera", take<Action::sceneCamera>, GLFW_KEY_HOME},
    Shortcut{"gamepad", "left stick moves, right stick looks, bumpers rise and sink, triggers zoom"},
};

constexpr std::array kLens{
    Shortcut{"alt + wheel", "narrow or widen the lens, 90 to 0.001 degrees, toward the cursor"},
};

constexpr std::array kComparing{
    Shortcut{"1 to 6", "standard, cdr, log, logcdr, reversed, anchored", choosePreset, GLFW_KEY_1,
             kPresetKeys},
    Shortcut{"shift + 1 to 6", "the same for the right side of a split screen"},
    Shortcut{"C", "split the screen, or join it", toggleComparison, GLFW_KEY_C},
    Shortcut{"drag the divider", "wipe from one technique to the other"},
    Shortcut{"V",
             "next view: shaded, cascades, distance, ids, wrong pixels, flips; with shift, the one before",
             stepView, GLFW_KEY_V},
};

constexpr std::array kEyes{
    Shortcut{
        "G",
        "two eyes side by side, then as an anaglyph, then one; with shift, parallel, toed-in or off-axis",
        chooseEyes, GLFW_KEY_G},
};

constexpr std::array kMeasuring{
    Shortcut{"click", "name what is there, its place and distance; a second click measures from the first"},
    Shortcut{"X", "forget both", take<Action::forgetMeasuring>, GLFW_KEY_X},
};

constexpr std::array kKeeping{
    Shortcut{"T", "a tour: from a space station's window to a runway's number", take<Action::tour>,
             GLFW_KEY_T},
    Shortcut{"space", "follow the scene's own camera path, or stop", toggleScenePath, GLFW_KEY_SPACE},
    Shortcut{"K", "play a file's animation, or pause; the panel Camera chooses one", toggleAnimation,
             GLFW_KEY_K},
    Shortcut{"R", "record the camera's path, or end and save the recording", take<Action::record>,
             GLFW_KEY_R},
    Shortcut{"P", "play what was recorded", take<Action::playRecording>, GLFW_KEY_P},
    Shortcut{"F11", "record what is shown as a video, both sides beside each other, or end it",
             take<Action::video>, GLFW_KEY_F11},
    Shortcut{"F12", "write the picture to a file; with shift, the whole window", takeScreenshot,
             GLFW_KEY_F12},
    Shortcut{"ctrl + C",
             "copy the command line that renders this picture without a window, or one for each side",
             take<Action::copyCommandLine>, GLFW_KEY_C, 1, GLFW_MOD_CONTROL},
    Shortcut{"drop a file", "open a .gltf or .glb scene"},
    Shortcut{"tab", "show or hide the panels", togglePanels, GLFW_KEY_TAB},
    Shortcut{"F2 to F6",
             "choose in a panel by arrows, enter and space; esc gives the keys back to the camera", showPanel,
             GLFW_KEY_F2, kPanels.size()},
    Shortcut{"F1", "show or hide this help", toggleHelp, GLFW_KEY_F1},
    Shortcut{"ctrl + Q", "close the window; to sink slowly, use ctrl and page down", take<Action::quit>,
             GLFW_KEY_Q, 1, GLFW_MOD_CONTROL},
};

constexpr std::array kSections{
    ShortcutSection{"Moving", kMoving},       ShortcutSection{"Lens", kLens},
    ShortcutSection{"Comparing", kComparing}, ShortcutSection{"Eyes", kEyes},
    ShortcutSection{"Measuring", kMeasuring}, ShortcutSection{"Keeping", kKeeping},
};

/// The shortcut of a key; null where it has none.
const Shortcut* shortcutOf(int key, int modifiers) {
    for (const ShortcutSection& section : kSections) {
        for (const Shortcut& shortcut : section.shortcuts) {
            if (shortcut.act != nullptr && shortcut.modifiers == modifiers && key >= shortcut.key &&
                key < shortcut.key + static_cast<int>(shortcut.count)) {
                return &shortcut;
            }
        }
    }
    return nullptr;
}

} // namespace

void aimPivot(CameraModel& camera, const Measuring& measuring) {
    if (!measuring.first() && camera.surfaceView > 0.0) {
        camera.pivot = camera.now.position - camera.now.back * camera.surfaceView;
    }
}

void beginOrbit(CameraModel& camera, const Measuring& measuring) {
    if (!camera.orbits) {
        aimPivot(camera, measuring);
        camera.orbits = true;
    }
}

bool followsPath(const CameraModel& camera) {
    return camera.motion == Motion::scenePath || (camera.motion == Motion::free && camera.followsAnimation &&
                                                  camera.animatedFrame && camera.playback.isPlaying);
}

void togglePath(CameraModel& camera) {
    if (!followsPath(camera)) {
        camera.motion = Motion::scenePath;
    } else if (camera.motion == Motion::scenePath) {
        camera.motion = Motion::free;
    } else {
        camera.playback.isPlaying = false;
    }
}

bool isForEveryPlace(const KeyInput& key) {
    return (key.key >= GLFW_KEY_F1 && key.key <= GLFW_KEY_F12) || key.key == GLFW_KEY_ESCAPE ||
           (key.modifiers & GLFW_MOD_CONTROL) != 0;
}

std::span<const ShortcutSection> shortcuts() {
    return kSections;
}

void applyShortcut(const KeyInput& key, ViewerModel& model) {
    if (!key.pressed || key.repeated) {
        return;
    }
    if (key.key == GLFW_KEY_ESCAPE) {
        escape(model);
        return;
    }
    const Shortcut* shortcut = shortcutOf(key.key, key.modifiers & GLFW_MOD_CONTROL);
    if (shortcut == nullptr) {
        shortcut = shortcutOf(key.key, 0);
    }
    if (shortcut != nullptr) {
        shortcut->act(model, {.place = static_cast<std::size_t>(key.key - shortcut->key),
                              .shift = (key.modifiers & GLFW_MOD_SHIFT) != 0});
    }
}

} // namespace cdr::viewer
