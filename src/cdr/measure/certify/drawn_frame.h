#pragma once

#include <cdr/depth/cascade.h>
#include <cdr/depth/technique.h>
#include <cdr/image/image.h>
#include <cdr/scene/camera.h>

namespace cdr::measure {

/// A drawn picture as a certificate needs it: what each pixel shows, and how it was drawn.
struct DrawnFrame {
    scene::Camera camera;                ///< that looked
    depth::Technique technique;          ///< that it was drawn with
    depth::Cascades cascades;            ///< that the technique cut, nearest first
    image::ImageU32 ids;                 ///< object index + 1, 0 for background
    image::Raster<double> distancesView; ///< infinity for background
    /// By how far the device may move a vertex along x and along y, pixels: half a sub-pixel of its
    /// subPixelPrecisionBits.
    double snapPixels = 0.0;
    bool hasShadows = false; ///< shadows were drawn, so repaired pixels get true ones
};

} // namespace cdr::measure
