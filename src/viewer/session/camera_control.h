#pragma once

#include <viewer/state/camera/camera_input.h>
#include <viewer/state/model/viewer_model.h>
#include <viewer/state/picture_area.h>
#include <viewer/window/input_event.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace cdr::viewer {

/// Whose pointer and keys are at an event.
enum class InputOwner : std::uint8_t { picture, interface };

/// Turns events over the picture into camera motion, clicks, and moves of the divider.
class CameraControl {
  public:
    void handle(const InputEvent& event, const PictureArea& area, InputOwner owner, ViewerModel& model);
    /// Moves the model's camera by what was asked since the last call.
    void apply(const PictureArea& area, double seconds, ViewerModel& model);
    /// Moves a camera as if that had been asked for.
    /// @param shown whose obstacles stop it; null: none do.
    static void steer(const CameraInput& input, const RenderResult* shown, CameraModel& camera);
    /// Whether keys, buttons or a gamepad ask for motion without further events.
    bool isActive() const;
    /// Whether a button is held that moves the camera with the pointer.
    bool isDragging() const;
    struct Click {
        glm::dvec2 pixel;
        bool isDouble; ///< soon after one at the same place
    };
    /// What was clicked since the last call.
    std::optional<Click> takeClick() { return std::exchange(m_click, std::nullopt); }
    const glm::dvec2& cursor() const { return m_input.cursor; }
    bool dragsDivider() const { return m_dragsDivider; }

  private:
    void onButton(const ButtonInput& button, const PictureArea& area, InputOwner owner, ViewerModel& model);
    void onRelease(int button);
    void onMove(const MoveInput& move, const PictureArea& area, ViewerModel& model);
    void onKey(const KeyInput& key, InputOwner owner);
    /// Whether one of two keys of the same meaning is held.
    bool isHeld(int left, int right) const { return m_keys.contains(left) || m_keys.contains(right); }
    void readGamepad();

    CameraInput m_input;
    std::map<int, InputOwner> m_keys; ///< that are held, and whose each is
    std::optional<int> m_held;        ///< the mouse button that was pressed over the picture
    bool m_pans = false;              ///< that button shifts
    bool m_dragsDivider = false;
    glm::dvec2 m_pressed{0.0};
    glm::dvec2 m_clicked{0.0};
    double m_travelled = 0.0; ///< pixels since the press
    std::optional<Click> m_click;
    std::chrono::steady_clock::time_point m_clickedAt{};
};

} // namespace cdr::viewer
