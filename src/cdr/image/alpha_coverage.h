#pragma once

#include <cdr/image/image.h>

#include <span>

namespace cdr::image {

/// Multiplies the alpha of each level of a picture by a number of its own. A cutoff keeps a share of the alpha that is
/// interpolated between texels. The number brings this share as close as possible to that of the picture itself. Of numbers
/// that come as close, the nearest to 1 is taken.
/// @param cutoff in (0, 1]: texels with less alpha are cut away.
void keepCoverage(const ImageRgba8& picture, float cutoff, std::span<ImageRgba8> levels);

} // namespace cdr::image
