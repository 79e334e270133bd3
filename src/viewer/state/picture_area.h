#pragma once

#include "camera/camera_input.h"

namespace cdr::viewer {

/// Where the picture is in the window, pixels.
struct PictureArea {
    int x = 0;
    int y = 0;
    PictureExtent extent;
    double pixelsPerUnit = 1.0; ///< of the window's screen coordinates

    /// Pixels from the picture's top left corner.
    glm::dvec2 toPicture(double windowX, double windowY) const {
        return {windowX * pixelsPerUnit - x, windowY * pixelsPerUnit - y};
    }
    bool contains(const glm::dvec2& pixel) const {
        return pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < extent.width && pixel.y < extent.height;
    }
};

} // namespace cdr::viewer
