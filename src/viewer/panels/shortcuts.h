#pragma once

#include <viewer/state/model/viewer_model.h>
#include <viewer/window/input_event.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace cdr::viewer {

/// How the key of a shortcut was pressed.
struct Pressed {
    std::size_t place = 0; ///< among the shortcut's keys
    bool shift = false;
};

/// Keys, or what the mouse does, and what comes of it: a line of the help that F1 shows.
struct Shortcut {
    std::string_view keys;
    std::string_view meaning;
    /// What pressing one does. Null where the camera or the mouse does it.
    void (*act)(ViewerModel& model, const Pressed& pressed) = nullptr;
    int key = 0;           ///< the first, a code of GLFW
    std::size_t count = 1; ///< of neighbouring keys
    int modifiers = 0;     ///< GLFW_MOD_CONTROL; 0: acts with ctrl too, unless another shortcut needs both
};

struct ShortcutSection {
    std::string_view title;
    std::span<const Shortcut> shortcuts;
};

/// What F1 shows.
std::span<const ShortcutSection> shortcuts();

/// What a key does to the model, by shortcuts().
void applyShortcut(const KeyInput& key, ViewerModel& model);

/// Whether a key means the same while the keyboard chooses in a panel: F keys, escape, and those with ctrl.
bool isForEveryPlace(const KeyInput& key);

/// Where nothing was clicked, what the camera looks at becomes what it goes round.
void aimPivot(CameraModel& camera, const Measuring& measuring);
/// Whether the camera follows the scene's path. That of an animated camera is its animation.
bool followsPath(const CameraModel& camera);
/// Follows it, or stops. An animation stops with the camera that it moves.
void togglePath(CameraModel& camera);
/// Orbits what was clicked, or else what the camera looks at.
void beginOrbit(CameraModel& camera, const Measuring& measuring);

} // namespace cdr::viewer
