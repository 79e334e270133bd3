#pragma once

#include "viewer_model.h"

#include <cdr/image/image.h>

namespace cdr::viewer {

/// The picture as the window shows it, without the interface: one side's, or both with the divider between.
/// Empty while nothing is shown.
image::ImageRgba8 shownPicture(const ViewerModel& model);

/// The `cdr render` lines that draw what is shown, one for each picture, left first. Empty while nothing is.
std::string commandLinesOf(const ViewerModel& model);

} // namespace cdr::viewer
