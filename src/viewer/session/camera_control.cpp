#include "camera_control.h"

#include <cdr/gpu/vulkan_hpp.h>
#include <viewer/panels/shortcuts.h>
#include <viewer/state/camera/fly_controller.h>
#include <viewer/state/camera/gamepad.h>
#include <viewer/state/camera/lens_zoom.h>
#include <viewer/state/camera/obstacles.h>
#include <viewer/state/camera/stereo_view.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cdr::viewer {

namespace {

constexpr double kClickPixels = 4.0;   ///< more is a drag
constexpr double kDividerPixels = 8.0; ///< as near is on it
constexpr std::chrono::milliseconds kDoubleClick{400};

constexpr std::array<std::pair<int, CameraKey>, 16> kKeys{{{GLFW_KEY_W, CameraKey::forward},
                                                           {GLFW_KEY_UP, CameraKey::forward},
                                                           {GLFW_KEY_S, CameraKey::backward},
                                                           {GLFW_KEY_DOWN, CameraKey::backward},
                                                           {GLFW_KEY_A, CameraKey::left},
                                                           {GLFW_KEY_LEFT, CameraKey::left},
                                                           {GLFW_KEY_D, CameraKey::right},
                                                           {GLFW_KEY_RIGHT, CameraKey::right},
                                                           {GLFW_KEY_E, CameraKey::up},
                                                           {GLFW_KEY_PAGE_UP, CameraKey::up},
                                                           {GLFW_KEY_Q, CameraKey::down},
                                                           {GLFW_KEY_PAGE_DOWN, CameraKey::down},
                                                           {GLFW_KEY_LEFT_SHIFT, CameraKey::faster},
                                                           {GLFW_KEY_RIGHT_SHIFT, CameraKey::faster},
                                                           {GLFW_KEY_LEFT_CONTROL, CameraKey::slower},
                                                           {GLFW_KEY_RIGHT_CONTROL, CameraKey::slower}}};

bool moves(const CameraKeys& keys) {
    constexpr std::array kMoving{CameraKey::forward, CameraKey::backward, CameraKey::left,
                                 CameraKey::right,   CameraKey::up,       CameraKey::down};
    return std::any_of(kMoving.begin(), kMoving.end(), [&](CameraKey key) { return keys.has(key); });
}

} // namespace

void CameraControl::onRelease(int button) {
    if (m_held != button) {
        return;
    }
    if (button == GLFW_MOUSE_BUTTON_LEFT && !m_dragsDivider && m_travelled <= kClickPixels) {
        const auto now = std::chrono::steady_clock::now();
        const bool isSoon = now - std::exchange(m_clickedAt, now) <= kDoubleClick;
        m_click = Click{.pixel = m_pressed,
                        .isDouble = isSoon && glm::distance(m_pressed, m_clicked) <= kClickPixels};
        m_clicked = m_pressed;
    }
    m_held.reset();
    m_dragsDivider = false;
}

void CameraControl::onButton(const ButtonInput& button, const PictureArea& area, InputOwner owner,
                             ViewerModel& model) {
    if (!button.pressed) {
        onRelease(button.button);
        return;
    }
    if (owner == InputOwner::interface || m_held || !area.contains(m_input.cursor)) {
        return;
    }
    m_held = button.button;
    m_pressed = m_input.cursor;
    m_travelled = 0.0;
    const double divider = model.settings.divider * area.extent.width;
    m_dragsDivider = button.button == GLFW_MOUSE_BUTTON_LEFT && model.settings.second &&
                     std::abs(m_input.cursor.x - divider) <= kDividerPixels * area.pixelsPerUnit;
    m_pans = button.button == GLFW_MOUSE_BUTTON_MIDDLE && isHeld(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    if (button.button == GLFW_MOUSE_BUTTON_MIDDLE && !model.camera.orbits) {
        aimPivot(model.camera, model.picture.measuring);
    }
}

void CameraControl::onMove(const MoveInput& move, const PictureArea& area, ViewerModel& model) {
    const glm::dvec2 cursor = area.toPicture(move.x, move.y);
    const glm::dvec2 by = cursor - m_input.cursor;
    m_input.cursor = cursor;
    if (m_dragsDivider) {
        model.settings.divider = std::clamp(cursor.x / area.extent.width, 0.0, 1.0);
        return;
    }
    m_travelled += glm::length(by);
    if (!isDragging()) {
        return;
    }
    if (*m_held == GLFW_MOUSE_BUTTON_LEFT) {
        m_input.drag += by;
    } else if (*m_held == GLFW_MOUSE_BUTTON_RIGHT) {
        m_input.look += by;
    } else {
        (m_pans ? m_input.pan : m_input.turn) += by;
    }
}

void CameraControl::onKey(const KeyInput& key, InputOwner owner) {
    if (key.pressed) {
        m_keys[key.key] = owner;
    } else {
        m_keys.erase(key.key);
    }
    m_input.keys = {};
    for (const auto& [code, meaning] : kKeys) {
        const auto held = m_keys.find(code);
        if (held != m_keys.end() && held->second == InputOwner::picture) {
            m_input.keys.set(meaning, true);
        }
    }
}

void CameraControl::handle(const InputEvent& event, const PictureArea& area, InputOwner owner,
                           ViewerModel& model) {
    const bool isOfPicture = owner == InputOwner::picture;
    if (const auto* move = std::get_if<MoveInput>(&event)) {
        onMove(*move, area, model);
    } else if (std::holds_alternative<LeaveInput>(event)) {
        if (!m_held) { // what is dragged goes on outside the window
            m_input.cursor = kNoCursor;
        }
    } else if (const auto* button = std::get_if<ButtonInput>(&event)) {
        onButton(*button, area, owner, model);
    } else if (const auto* scroll = std::get_if<ScrollInput>(&event)) {
        if (isOfPicture && area.contains(m_input.cursor)) {
            (isHeld(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT) ? m_input.lens : m_input.scroll) += scroll->y;
        }
    } else if (const auto* key = std::get_if<KeyInput>(&event)) {
        onKey(*key, owner);
    }
}

void CameraControl::readGamepad() {
    m_input.axes = {};
    GLFWgamepadstate state{};
    if (glfwJoystickIsGamepad(GLFW_JOYSTICK_1) != GLFW_TRUE ||
        glfwGetGamepadState(GLFW_JOYSTICK_1, &state) != GLFW_TRUE) {
        return;
    }
    m_input.axes = gamepadAxes({.leftX = state.axes[GLFW_GAMEPAD_AXIS_LEFT_X],
                                .leftY = state.axes[GLFW_GAMEPAD_AXIS_LEFT_Y],
                                .rightX = state.axes[GLFW_GAMEPAD_AXIS_RIGHT_X],
                                .rightY = state.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y],
                                .leftTrigger = state.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER],
                                .rightTrigger = state.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER],
                                .leftBumper = state.buttons[GLFW_GAMEPAD_BUTTON_LEFT_BUMPER] != 0,
                                .rightBumper = state.buttons[GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER] != 0});
}

bool CameraControl::isActive() const {
    return moves(m_input.keys) || !(m_input.axes == CameraAxes{});
}

bool CameraControl::isDragging() const {
    return m_held && !m_dragsDivider && m_travelled > kClickPixels;
}

void CameraControl::apply(const PictureArea& area, double seconds, ViewerModel& model) {
    readGamepad();
    m_input.extent = extentOfEye(model.settings, area.extent);
    m_input.seconds = seconds;
    m_input.flies = m_held == GLFW_MOUSE_BUTTON_RIGHT;
    CameraInput input = m_input;
    input.cursor = inEye(model.settings, area.extent, input.cursor);
    m_input.drag = m_input.look = m_input.turn = m_input.pan = glm::dvec2(0.0);
    m_input.scroll = m_input.lens = 0.0;
    const bool drags = input.drag + input.look + input.turn + input.pan != glm::dvec2(0.0);
    if ((isActive() || drags || input.scroll != 0.0 || input.lens != 0.0) && model.camera.isThere) {
        model.camera.motion = Motion::free; // whoever steers takes over
        model.camera.followsAnimation = false;
        steer(input, model.picture.shown.get(), model.camera);
    }
}

void CameraControl::steer(const CameraInput& input, const RenderResult* shown, CameraModel& camera) {
    if (!camera.isThere) {
        return;
    }
    const scene::Camera before = camera.now;
    if (input.lens != 0.0 || input.axes.zoom != 0.0) {
        camera.now = zoomLens(camera.now, input);
    }
    const bool orbits = camera.orbits && !input.flies;
    CameraInput flying = input;
    CameraInput turning = input;
    flying.drag = input.look + (orbits ? glm::dvec2(0.0) : input.drag);
    turning.drag = input.turn + (orbits ? input.drag : glm::dvec2(0.0));
    CameraInput& resting = orbits ? flying : turning; // keys, wheel and sticks are the other's
    resting.keys = {};
    resting.axes = {};
    resting.scroll = 0.0;
    camera.now = fly(camera.now, flying, camera.surfaceView);
    if (shown != nullptr && shown->obstacles != nullptr) {
        camera.now = stopped(before, camera.now, *shown->obstacles);
    }
    const Orbit orbited = orbit({.camera = camera.now, .pivot = camera.pivot}, turning);
    camera.pivot = orbited.pivot;
    camera.now = scene::canonical(orbited.camera); // as the copied command line has it, to the bit
    // The next picture may come late.
    camera.surfaceView = std::max(surfaceAhead(camera.now, before, camera.surfaceView), camera.now.nearView);
}

} // namespace cdr::viewer
