#pragma once

#include "model/picture_model.h"

#include <cdr/image/image.h>

#include <string>

namespace cdr::viewer {

/// The picture as the window shows it, without the interface: one side's, or both with the divider between.
/// Empty while nothing is shown.
/// @param divider where it stands, 0 to 1 of the width
image::ImageRgba8 shownPicture(const RenderResult* shown, double divider);

/// The `cdr render` lines that draw what is shown, one for each picture, left first. Empty while nothing is.
std::string commandLinesOf(const PictureModel& picture);

} // namespace cdr::viewer
