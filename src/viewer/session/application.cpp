#include "application.h"

#include "startup.h"
#include "statistics_report.h"

#include <cdr/base/format_error.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>
#include <cdr/platform/standard_streams.h>
#include <viewer/panels/overlay.h>
#include <viewer/panels/panels.h>
#include <viewer/panels/shortcuts.h>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace cdr::viewer {

namespace {

constexpr float kSidebarWidth = 348.0f; ///< at 96 dots per inch
constexpr float kMinPicture = 160.0f;   ///< beside it, else it hides
/// The interface's pace while pictures come more slowly than that, milliseconds.
constexpr std::chrono::milliseconds kRedrawEvery{33};
constexpr double kIdleSeconds = 0.25;
constexpr double kBusySeconds = 0.004;
constexpr int kSettleFrames = 3;
constexpr std::size_t kMaxIntervals = 1'000'000;

std::string describe(const gpu::DeviceInfo& info) {
    return fmt::format("{}, {}", info.name, info.driver);
}

InputOwner ownerIf(bool isPicture) {
    return isPicture ? InputOwner::picture : InputOwner::interface;
}

double secondsSince(std::chrono::steady_clock::time_point then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

} // namespace

Application::Application(const Arguments& arguments, Player* player)
    : m_arguments(arguments),
      m_model(initialModel(arguments)),
      m_player(player),
      m_system(fmt::format("cdr render {} -o picture.png", arguments.settings.scene)),
      m_renderInstance({.validate = arguments.validate, .extensions = {}}),
      m_renderDevice(m_renderInstance, arguments.device),
      m_window(m_system, firstSize(arguments, m_model.settings), "cdr-viewer"),
      m_ui(m_system, m_window, {.choice = arguments.device, .validate = arguments.validate}),
      m_presenter(m_ui, m_window, arguments.waitsForDisplay ? Pace::display : Pace::newest),
      m_interface(m_ui, m_window, m_presenter, arguments.uiScale),
      m_session(m_renderDevice, m_model) {
    m_model.performance.device = describe(m_renderDevice.device().info());
    m_model.performance.uiDevice = describe(m_ui.device().info());
}

bool Application::goesOn() const {
    const bool isOver = m_arguments.frames && m_uiFrames >= *m_arguments.frames;
    return !m_quits && !isOver && !m_window.isClosing();
}

void Application::wait() const {
    const bool isPlayed = m_player != nullptr;
    const bool isMinimised = m_window.extent().width == 0 || m_window.extent().height == 0;
    const bool isBusy = isPlayed || ((m_redraws > 0 || m_control.isActive()) && !isMinimised);
    if (waitsForPicture()) {
        m_window.wait(std::chrono::duration<double>(kRedrawEvery).count()); // or until the picture is there
    } else if (isBusy) {
        m_window.wait(isPlayed && m_session.isSettled() ? 0.0 : kBusySeconds);
    } else {
        m_window.wait(isMoving() && !isMinimised ? std::chrono::duration<double>(kRedrawEvery).count()
                                                 : kIdleSeconds);
    }
}

void Application::stepPlayer() {
    const PlayerState state = m_player->step({.window = m_window,
                                              .session = m_session,
                                              .model = m_model,
                                              .places = m_places,
                                              .area = pictureArea(),
                                              .capture = m_capture});
    m_quits = m_quits || state == PlayerState::quits;
    m_playerWaits = state == PlayerState::waits;
    if (!waitsForPicture()) {
        m_redraws = std::max(m_redraws, 1);
    }
    if (state == PlayerState::hasEnded) {
        m_player = nullptr;
    }
}

double Application::secondsOfUpdate() {
    const double seconds = secondsSince(std::exchange(m_lastUpdate, Clock::now()));
    return m_player != nullptr ? Player::kStepSeconds : seconds;
}

InputOwner Application::handleKey(const KeyInput& key) {
    InterfaceModel& interface = m_model.interface;
    if (sidebarWidth() <= 0.0f) {
        interface.panelKeys.reset(); // the window has become too narrow for them
    }
    if (m_interface.wantsKeys() || (interface.panelKeys && !isForEveryPlace(key)) ||
        (key.key == GLFW_KEY_ESCAPE && m_interface.wantsEscape())) {
        return InputOwner::interface;
    }
    const bool wasWanted = interface.showsPanel;
    applyShortcut(key, m_model);
    const bool isAskedFor = interface.panelKeys || (interface.showsPanel && !wasWanted);
    if (isAskedFor && sidebarWidth() <= 0.0f) {
        interface.panelKeys.reset();
        interface.sayProblem("the window is too narrow for the panels");
    }
    return ownerIf(!interface.panelKeys);
}

void Application::handleInput() {
    const PictureArea area = pictureArea();
    for (const InputEvent& event : m_window.takeEvents()) {
        m_redraws = kSettleFrames;
        const InputOwner pointer = ownerIf(m_control.dragsDivider() || !m_interface.wantsPointer());
        if (const auto* drop = std::get_if<DropInput>(&event)) {
            dropFiles(*drop);
        } else if (const auto* key = std::get_if<KeyInput>(&event)) {
            m_control.handle(event, area, handleKey(*key), m_model);
        } else {
            if (pointer == InputOwner::picture && std::holds_alternative<ButtonInput>(event) &&
                area.contains(m_control.cursor())) {
                m_model.interface.panelKeys.reset(); // a click on the picture gives it the keys too
            }
            m_control.handle(event, area, pointer, m_model);
        }
    }
    if (const auto click = m_control.takeClick()) {
        if (click->isDouble) {
            m_model.picture.measuring.clear(); // no way from a point to itself
            beginOrbit(m_model.camera, m_model.picture.measuring);
        }
        m_session.click(click->pixel);
    }
}

float Application::sidebarWidth() const {
    const float width = kSidebarWidth * m_interface.scale();
    const float window = static_cast<float>(m_window.extent().width / m_window.pixelsPerUnit());
    return m_model.interface.showsPanel && window >= width + kMinPicture * m_interface.scale() ? width : 0.0f;
}

PictureArea Application::pictureArea() const {
    PictureArea area;
    area.pixelsPerUnit = m_window.pixelsPerUnit();
    const vk::Extent2D window = m_window.extent();
    const auto sidebar = static_cast<std::uint32_t>(std::lround(sidebarWidth() * area.pixelsPerUnit));
    area.extent = {std::max(window.width - std::min(sidebar, window.width), 1u), std::max(window.height, 1u)};
    return area;
}

bool Application::isMoving() const {
    return m_model.camera.motion != Motion::free || m_model.camera.playback.isPlaying ||
           m_model.performance.rendersAlways || m_model.video != nullptr || m_isMissed ||
           m_arguments.frames || !m_session.isSettled();
}

bool Application::isRedrawDue() const {
    const auto now = Clock::now();
    return m_redraws > 0 || m_model.interface.notice.isOverSince(m_lastFrame, now) ||
           (isMoving() && now - m_lastFrame >= kRedrawEvery);
}

void Application::layOut() {
    if (const float width = sidebarWidth(); width > 0.0f) {
        drawSidebar(m_widgets, m_places, width, m_model);
    }
    if (m_model.interface.showsHelp) {
        drawHelp(m_model.interface);
    }
    drawOverlay(pictureArea(), m_model);
}

void Application::present(image::ImageRgba8* capture, ImDrawData* drawn) {
    const PictureArea area = pictureArea();
    const PictureLayout layout{
        .extent = {area.extent.width, area.extent.height},
        .divider = m_model.settings.divider,
        .pictures = m_model.picture.shown != nullptr ? m_model.picture.shown->sides.size() : 1};
    const auto begin = Clock::now();
    m_isMissed = !m_presenter.draw(layout, drawn, capture);
    m_model.performance.presentMs = 1000.0 * secondsSince(begin);
}

void Application::presentAndSave(ImDrawData* drawn) {
    m_unsaved.reset();
    image::ImageRgba8 pixels;
    try {
        present(&pixels, drawn);
        if (!pixels.pixels.empty()) {
            image::writeImage(*std::exchange(m_capture, std::nullopt), pixels);
        }
    } catch (const base::RunError& error) {
        // There was no memory to read the window into, or no place for the file. What else failed fails again without it.
        m_capture.reset();
        m_unsaved = error.what();
        m_model.interface.sayProblem(error.what());
    }
}

void Application::drawFrame() {
    const vk::Extent2D extent = m_window.extent();
    if (extent.width == 0 || extent.height == 0) {
        return;
    }
    const auto begin = Clock::now();
    const double interval = std::chrono::duration<double>(begin - m_lastFrame).count();
    if (m_arguments.statistics && m_uiIntervals.size() < kMaxIntervals) {
        m_uiIntervals.push_back(1000.0 * interval);
    }
    m_lastFrame = begin;
    m_places.beginFrame();
    m_interface.begin(m_player != nullptr ? Player::kStepSeconds : interval,
                      m_model.interface.panelKeys ? ArrowKeys::choose : ArrowKeys::fly);
    layOut();
    ImDrawData* drawn = m_interface.end();
    if (m_capture) {
        presentAndSave(drawn);
    } else {
        present(nullptr, drawn);
    }
    m_model.performance.uiFrameMs = 1000.0 * secondsSince(begin);
    m_redraws = std::max(m_redraws - 1, 0);
    ++m_uiFrames;
}

void Application::run() {
    std::exception_ptr failure;
    try {
        serve();
    } catch (...) {
        failure = std::current_exception();
    }
    finish(failure);
}

void Application::serve() {
    const auto began = Clock::now();
    while (goesOn()) {
        wait();
        if (m_player != nullptr) {
            stepPlayer();
        }
        handleInput();
        for (const Action action : std::exchange(m_model.actions, {})) {
            perform(action);
            m_redraws = kSettleFrames;
        }
        if (m_session.takeOpening()) {
            m_redraws = std::max(m_redraws, 1);
        }
        if (m_session.takeResult()) {
            for (std::size_t side = 0; side < m_model.picture.shown->sides.size(); ++side) {
                m_presenter.picture(side).set(m_model.picture.shown->sides[side].picture);
            }
            m_redraws = std::max(m_redraws, 1);
        }
        const double seconds = secondsOfUpdate();
        recordVideo(seconds);
        m_control.apply(pictureArea(), seconds, m_model);
        m_model.interface.firstSteps.see(m_model.settings, m_model.camera.now);
        if (m_window.extent().width > 0 && m_window.extent().height > 0) {
            m_session.update({.area = pictureArea(),
                              .cursor = m_control.cursor(),
                              .seconds = seconds,
                              .isSteered = m_control.isActive(),
                              .isDragged = m_control.isDragging()});
        }
        if (isRedrawDue()) {
            drawFrame();
        }
    }
    if (m_arguments.statistics) {
        platform::printOutput(
            statisticsReport(m_model.performance, m_session.results(), secondsSince(began), m_uiIntervals));
    }
}

void Application::saveScreenshot() {
    m_capture = m_arguments.screenshot;
    constexpr int kTries = 3; // the window may just have changed its size
    for (int attempt = 0; attempt < kTries && m_capture; ++attempt) {
        drawFrame();
    }
    if (m_unsaved) {
        throw base::RunError(*m_unsaved);
    }
    if (m_capture) {
        throw base::runError("{}: there is no screenshot, since the window could not be drawn or read",
                             platform::oneLine(m_arguments.screenshot));
    }
}

void Application::finish(std::exception_ptr failure) {
    const bool isFailed = failure != nullptr;
    // Thrown at the end, since nobody sees a notice any more.
    const auto attempt = [&](void (Application::*save)()) {
        try {
            (this->*save)();
        } catch (...) {
            failure = failure != nullptr ? failure : std::current_exception();
        }
    };
    if (m_model.video != nullptr) {
        attempt(&Application::toggleVideo);
    }
    if (m_model.camera.recorder.isRecording() || m_model.camera.isPathUnsaved) {
        attempt(&Application::toggleRecording);
    }
    if (!isFailed && !m_arguments.screenshot.empty()) {
        attempt(&Application::saveScreenshot);
    }
    m_window.hide(); // the end waits for the picture being rendered; hidden meanwhile
    if (failure != nullptr) {
        std::rethrow_exception(failure);
    }
}

} // namespace cdr::viewer
