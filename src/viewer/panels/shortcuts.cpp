#include "shortcuts.h"

#include <cdr/gpu/vulkan_hpp.h>
#include <viewer/state/camera/stereo_view.h>

#include <GLFW/glfw3.h>

namespace cdr::viewer {

namespace {

void toggleComparison(ViewSettings& settings) {
    if (settings.second) {
        settings.second.reset();
    } else {
        settings.second = depth::parseTechnique("anchored");
    }
}

void stepView(ViewSettings& settings, std::size_t steps) {
    const auto now = static_cast<std::size_t>(settings.view);
    settings.view = kViewKinds[(now + steps) % kViewKinds.size()];
}

void toggleMotion(CameraModel& camera, Motion motion) {
    camera.motion = camera.motion == motion ? Motion::free : motion;
}

void toggleAnimation(ViewerModel& model) {
    model.camera.playback.isPlaying = !model.camera.playback.isPlaying;
    const bool hasAny = model.picture.shown != nullptr &&
                        model.picture.shown->sceneName == model.settings.scene &&
                        !model.picture.shown->scene->animations.empty();
    if (hasAny && !model.settings.choice.framesPerSecond) {
        model.settings.choice = withAnimation(model.settings.choice, 0);
    }
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

bool isForEveryPlace(const KeyInput& key) {
    return (key.key >= GLFW_KEY_F1 && key.key <= GLFW_KEY_F12) || key.key == GLFW_KEY_ESCAPE ||
           (key.modifiers & GLFW_MOD_CONTROL) != 0;
}

void applyShortcut(const KeyInput& key, ViewerModel& model) {
    if (!key.pressed || key.repeated) {
        return;
    }
    const bool shift = (key.modifiers & GLFW_MOD_SHIFT) != 0;
    const bool control = (key.modifiers & GLFW_MOD_CONTROL) != 0;
    if (key.key >= GLFW_KEY_1 && key.key < GLFW_KEY_1 + static_cast<int>(kPresetKeys)) {
        const std::size_t side = shift && model.settings.second ? 1 : 0;
        model.settings = withPreset(model.settings, side, static_cast<std::size_t>(key.key - GLFW_KEY_1) + 1);
        return;
    }
    if (key.key >= GLFW_KEY_F2 && key.key < GLFW_KEY_F2 + static_cast<int>(kPanels.size())) {
        model.interface.panelKeys = PanelKeys{.panel = static_cast<std::size_t>(key.key - GLFW_KEY_F2)};
        model.interface.showsPanel = true;
        return;
    }
    switch (key.key) {
    case GLFW_KEY_F1:
        model.interface.showsHelp = !model.interface.showsHelp;
        break;
    case GLFW_KEY_ESCAPE:
        if (model.interface.panelKeys) {
            model.interface.panelKeys.reset();
        } else {
            model.interface.showsHelp = false;
            model.interface.firstSteps.end();
        }
        break;
    case GLFW_KEY_TAB:
        model.interface.showsPanel = !model.interface.showsPanel;
        break;
    case GLFW_KEY_C:
        if (control) {
            model.actions.push_back(Action::copyCommandLine);
        } else {
            toggleComparison(model.settings);
        }
        break;
    case GLFW_KEY_Q:
        if (control) {
            model.actions.push_back(Action::quit);
        }
        break;
    case GLFW_KEY_V:
        stepView(model.settings, shift ? kViewKinds.size() - 1 : 1);
        break;
    case GLFW_KEY_G:
        model.settings = shift ? withOtherEyes(std::move(model.settings))
                               : withNextStereo(std::move(model.settings), model.camera.surfaceView);
        break;
    case GLFW_KEY_O:
        if (model.camera.orbits) {
            model.camera.orbits = false;
        } else {
            beginOrbit(model.camera, model.picture.measuring);
        }
        break;
    case GLFW_KEY_SPACE:
        toggleMotion(model.camera, Motion::scenePath);
        break;
    case GLFW_KEY_K:
        toggleAnimation(model);
        break;
    case GLFW_KEY_HOME:
        model.actions.push_back(Action::sceneCamera);
        break;
    case GLFW_KEY_F:
        model.actions.push_back(Action::frameSelected);
        break;
    case GLFW_KEY_T:
        model.actions.push_back(Action::tour);
        break;
    case GLFW_KEY_R:
        model.actions.push_back(Action::record);
        break;
    case GLFW_KEY_P:
        model.actions.push_back(Action::playRecording);
        break;
    case GLFW_KEY_X:
        model.actions.push_back(Action::forgetMeasuring);
        break;
    case GLFW_KEY_F11:
        model.actions.push_back(Action::video);
        break;
    case GLFW_KEY_F12:
        model.actions.push_back(shift ? Action::screenshotWindow : Action::screenshotPicture);
        break;
    default:
        break;
    }
}

} // namespace cdr::viewer
