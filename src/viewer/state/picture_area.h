#pragma once

#include "camera/camera_input.h"

namespace cdr::viewer {

/// What the picture takes of the window, from its top left corner.
struct PictureArea {
    PictureExtent extent;       ///< pixels
    double pixelsPerUnit = 1.0; ///< of the window's screen coordinates

    /// Pixels from the picture's top left corner.
    glm::dvec2 toPicture(double windowX, double windowY) const {
        return {windowX * pixelsPerUnit, windowY * pixelsPerUnit};
    }
    bool contains(const glm::dvec2& pixel) const {
        return pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < extent.width && pixel.y < extent.height;
    }
};

} // namespace cdr::viewer
