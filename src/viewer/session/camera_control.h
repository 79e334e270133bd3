#pragma once

#include "viewer_model.h"

#include <viewer/state/camera_input.h>
#include <viewer/window/input_event.h>

#include <optional>

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

/// Turns events over the picture into camera motion, clicks, and moves of the divider.
class CameraControl {
  public:
    /// @param free whether the interface leaves pointer and keys to the picture.
    void handle(const InputEvent& event, const PictureArea& area, bool free, ViewerModel& model);
    /// Moves the model's camera by what was asked since the last call.
    void apply(const PictureArea& area, double seconds, ViewerModel& model);
    /// Moves the model's camera as if that had been asked for.
    /// @param zooms whether scrolling is for the lens though the camera orbits.
    static void steer(CameraInput input, bool zooms, ViewerModel& model);
    /// Whether keys, buttons or a gamepad ask for motion without further events.
    bool isActive() const;
    /// A pixel that was clicked since the last call.
    std::optional<glm::dvec2> takeClick();
    const glm::dvec2& cursor() const { return m_input.cursor; }
    bool dragsDivider() const { return m_dragsDivider; }

  private:
    void onButton(const ButtonInput& button, const PictureArea& area, bool free, const ViewerModel& model);
    void onMove(const MoveInput& move, const PictureArea& area, ViewerModel& model);
    void readGamepad();

    CameraInput m_input;
    bool m_turns = false; ///< the button that looks about is held
    bool m_pans = false;
    bool m_dollies = false; ///< scrolling is for an orbit's distance instead of the lens
    bool m_dragsDivider = false;
    glm::dvec2 m_pressed{0.0};
    double m_travelled = 0.0; ///< pixels since the press
    std::optional<glm::dvec2> m_click;
};

} // namespace cdr::viewer
