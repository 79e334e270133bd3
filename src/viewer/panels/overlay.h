#pragma once

#include <viewer/session/camera_control.h>
#include <viewer/session/viewer_model.h>

namespace cdr::viewer {

/// What lies over the picture: each side's label, the divider, picked points, and notices.
void drawOverlay(const PictureArea& area, const ViewerModel& model);

} // namespace cdr::viewer
