#pragma once

#include <viewer/state/model/viewer_model.h>
#include <viewer/state/picture_area.h>

namespace cdr::viewer {

/// What lies over the picture: each side's label, the divider, picked points, and notices.
void drawOverlay(const PictureArea& area, const ViewerModel& model);

} // namespace cdr::viewer
