#pragma once

#include <cdr/image/image.h>

#include <cstdint>

namespace cdr::viewer {

/// The first column right of a divider.
/// @param share of the width that is left of it; below 0 and above 1 are held.
std::uint32_t dividerColumn(double share, std::uint32_t width);

/// The left part of one picture beside the right part of another, with a light line of two pixels between
/// them. No line at the borders. base::InputError when the sizes differ.
void composeSplit(const image::ImageRgba8& left, const image::ImageRgba8& right, double divider,
                  image::ImageRgba8& picture);

} // namespace cdr::viewer
