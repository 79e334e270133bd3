#pragma once

#include <viewer/state/model/viewer_model.h>
#include <viewer/window/input_event.h>

namespace cdr::viewer {

/// What a key does to the model, those that move the camera aside. helpText() lists them.
void applyShortcut(const KeyInput& key, ViewerModel& model);

/// Whether a key means the same while the keyboard chooses in a panel: F keys, escape, and those with ctrl.
bool isForEveryPlace(const KeyInput& key);

/// Where nothing was clicked, what the camera looks at becomes what it goes round.
void aimPivot(CameraModel& camera, const Measuring& measuring);
/// Orbits what was clicked, or else what the camera looks at.
void beginOrbit(CameraModel& camera, const Measuring& measuring);

} // namespace cdr::viewer
