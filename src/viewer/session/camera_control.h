#pragma once

#include <viewer/state/camera/camera_input.h>
#include <viewer/state/picture_area.h>
#include <viewer/state/viewer_model.h>
#include <viewer/window/input_event.h>

#include <optional>

namespace cdr::viewer {

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
