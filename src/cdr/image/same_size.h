#pragma once

/// @file
/// @throws base::InputError where sizes differ.

#include <cdr/base/format_error.h>
#include <cdr/image/image.h>

#include <string_view>

namespace cdr::image {

/// Refuses two rasters that differ in size.
/// @param what the message begins with: what compares them, or whose size it is.
template <typename A, typename B>
void requireSameSize(const Raster<A>& a, const Raster<B>& b, std::string_view what) {
    if (a.width != b.width || a.height != b.height) {
        throw base::inputError("{}: {}x{} differs from {}x{}", what, a.width, a.height, b.width, b.height);
    }
}

} // namespace cdr::image
