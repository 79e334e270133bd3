#include "camera_control.h"

#include <viewer/state/camera/fly_controller.h>
#include <viewer/state/camera/gamepad.h>
#include <viewer/state/camera/lens_zoom.h>

#include <GLFW/glfw3.h>
#include <vulkan/vulkan.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cdr::viewer {

namespace {

constexpr double kClickPixels = 4.0;   ///< more is a drag
constexpr double kDividerPixels = 8.0; ///< as near is on it

constexpr std::array<std::pair<int, CameraKey>, 14> kKeys{{{GLFW_KEY_W, CameraKey::forward},
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
                                                           {GLFW_KEY_LEFT_CONTROL, CameraKey::slower}}};

bool moves(const CameraKeys& keys) {
    constexpr std::array kMoving{CameraKey::forward, CameraKey::backward, CameraKey::left,
                                 CameraKey::right,   CameraKey::up,       CameraKey::down};
    return std::any_of(kMoving.begin(), kMoving.end(), [&](CameraKey key) { return keys.has(key); });
}

} // namespace

void CameraControl::onButton(const ButtonInput& button, const PictureArea& area, bool free,
                             const ViewerModel& model) {
    const bool isLeft = button.button == GLFW_MOUSE_BUTTON_LEFT;
    if (!button.pressed) {
        if (isLeft && m_turns && m_travelled <= kClickPixels) {
            m_click = m_pressed;
        }
        m_turns = m_turns && !isLeft;
        m_pans = m_pans && isLeft;
        m_dragsDivider = m_dragsDivider && !isLeft;
        return;
    }
    if (!free || !area.contains(m_input.cursor)) {
        return;
    }
    const double divider = model.settings.divider * area.extent.width;
    if (isLeft && model.settings.second &&
        std::abs(m_input.cursor.x - divider) <= kDividerPixels * area.pixelsPerUnit) {
        m_dragsDivider = true;
        return;
    }
    m_turns = isLeft || m_turns;
    m_pans = !isLeft || m_pans;
    m_pressed = m_input.cursor;
    m_travelled = 0.0;
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
    if (m_turns && m_travelled > kClickPixels) {
        m_input.drag += by;
    }
    if (m_pans) {
        m_input.pan += by;
    }
}

void CameraControl::handle(const InputEvent& event, const PictureArea& area, bool free, ViewerModel& model) {
    if (const auto* move = std::get_if<MoveInput>(&event)) {
        onMove(*move, area, model);
    } else if (const auto* button = std::get_if<ButtonInput>(&event)) {
        onButton(*button, area, free, model);
    } else if (const auto* scroll = std::get_if<ScrollInput>(&event)) {
        if (free && area.contains(m_input.cursor)) {
            m_input.scroll += scroll->y;
        }
    } else if (const auto* key = std::get_if<KeyInput>(&event)) {
        if (key->key == GLFW_KEY_LEFT_CONTROL || key->key == GLFW_KEY_RIGHT_CONTROL) {
            m_dollies = key->pressed;
        }
        for (const auto& [code, meaning] : kKeys) {
            if (code == key->key) {
                m_input.keys.set(meaning, key->pressed && free);
            }
        }
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

void CameraControl::apply(const PictureArea& area, double seconds, ViewerModel& model) {
    readGamepad();
    m_input.extent = area.extent;
    m_input.seconds = seconds;
    const CameraInput input = m_input;
    m_input.drag = m_input.pan = glm::dvec2(0.0);
    m_input.scroll = 0.0;
    const bool asks =
        isActive() || input.drag != glm::dvec2(0.0) || input.pan != glm::dvec2(0.0) || input.scroll != 0.0;
    if (asks && model.hasCamera) {
        model.motion = Motion::free; // whoever steers takes over
        steer(input, !m_dollies, model);
    }
}

void CameraControl::steer(CameraInput input, bool zooms, ViewerModel& model) {
    if (!model.hasCamera) {
        return;
    }
    if (input.scroll != 0.0 && (!model.orbits || zooms)) {
        model.camera = zoomLens(model.camera, input);
        input.scroll = 0.0;
    }
    if (model.orbits) {
        const Orbit orbited = orbit({.camera = model.camera, .pivot = model.pivot}, input);
        model.camera = orbited.camera;
        model.pivot = orbited.pivot;
    } else {
        model.camera = fly(model.camera, input, model.surfaceView);
    }
    model.camera = scene::canonical(model.camera); // what the copied command line says, to the bit
}

std::optional<glm::dvec2> CameraControl::takeClick() {
    return std::exchange(m_click, std::nullopt);
}

} // namespace cdr::viewer
