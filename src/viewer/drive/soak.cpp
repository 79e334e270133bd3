#include "soak.h"

#include <cdr/image/codec.h>
#include <cdr/platform/standard_streams.h>
#include <viewer/session/camera_control.h>
#include <viewer/state/shown_picture.h>

#include <fmt/format.h>
#include <program/allocator.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cdr::viewer {

namespace {

constexpr std::uint64_t kMinimisedSteps = 5;
/// Pictures that are rendered in the view where memory is measured, and then frames of the interface. Drivers
/// free what they kept for earlier frames while they draw these, and memory is measured after that.
constexpr std::uint64_t kRest = 30;
/// As many of a soak that is too short for its memory to say anything.
constexpr std::uint64_t kShortRest = 3;
constexpr double kShortSeconds = 60.0;

double megabytes(std::uint64_t bytes) {
    return static_cast<double>(bytes) / 1e6;
}

} // namespace

Soak::Soak(double seconds, SoakOptions input)
    : m_steps(std::max<std::uint64_t>(static_cast<std::uint64_t>(std::llround(seconds / kStepSeconds)), 1)),
      m_measurements(seconds < kShortSeconds ? kShortMeasurements : kMeasurements),
      m_rest(seconds < kShortSeconds ? kShortRest : kRest),
      m_input(std::move(input)) {}

void Soak::play(const PlayedViewer& viewer) {
    Window& window = viewer.window;
    ViewerModel& model = viewer.model;
    const SoakStep step = m_input.next();
    if (m_minimisedFor > 0 && --m_minimisedFor == 0) {
        window.inject(window.currentSize());
    }
    if (step.settings) {
        model.settings = *step.settings;
    }
    if (step.resize) {
        window.resize(static_cast<int>(step.resize->width), static_cast<int>(step.resize->height));
    }
    if (step.minimises && m_minimisedFor == 0) {
        window.inject(ResizeInput{0, 0});
        m_minimisedFor = kMinimisedSteps;
    }
    // The pointer runs over the interface too.
    window.inject(MoveInput{step.input.cursor.x, step.input.cursor.y});
    model.camera.orbits = step.orbits;
    CameraInput input = step.input;
    if (step.zooms) {
        input.lens = std::exchange(input.scroll, 0.0);
    }
    CameraControl::steer(input, model.picture.shown.get(), model.camera);
    if (step.click) {
        const PictureExtent& extent = viewer.area.extent;
        viewer.session.click({std::min<double>(step.click->x, extent.width - 1.0),
                              std::min<double>(step.click->y, extent.height - 1.0)});
    }
    if (step.screenshot) {
        const image::ImageRgba8 picture = shownPicture(model.picture.shown.get(), model.settings.divider);
        if (!picture.pixels.empty()) {
            image::encodePng(picture);
        }
    }
    if (step.returnsHome) {
        model.actions.push_back(Action::sceneCamera);
    }
}

void Soak::enter(Phase phase, const Session& session) {
    m_phase = phase;
    m_restedFrames = 0;
    m_results = session.results();
}

void Soak::rest(Window& window, const Session& session, ViewerModel& model) {
    enter(Phase::resting, session);
    m_minimisedFor = 0;
    window.resize(m_home->size.width, m_home->size.height);
    window.inject(window.currentSize());
    model.settings = m_home->settings;
    model.camera.orbits = false;
    model.camera.motion = Motion::free;
    model.actions.push_back(Action::sceneCamera);
}

void Soak::measure(Window& window, Session& session, ViewerModel& model) {
    window.inject(window.currentSize());
    model.performance.rendersAlways = session.results() < m_results + m_rest;
    if (model.performance.rendersAlways || !session.isSettled() || ++m_restedFrames < m_rest) {
        return;
    }
    program::returnFreeMemory();
    const std::uint64_t resident = program::residentBytes().value_or(0);
    if (m_phase == Phase::resting) {
        m_before = resident;
        session.renewDevice();
        enter(Phase::renewed, session);
        return;
    }
    const std::uint64_t allocated = program::allocatedBytes().value_or(0);
    m_memory.push_back({.before = m_before, .resident = resident, .allocated = allocated});
    platform::printNow(
        fmt::format("allocated {:.2f} MB, resident {:.1f} MB, {:.1f} MB before the device was made anew, "
                    "after {} of {} steps\n",
                    megabytes(allocated), megabytes(resident), megabytes(m_before), m_done, m_steps));
    enter(Phase::playing, session);
}

std::uint64_t Soak::stepsBeforeRest() const {
    const double share = static_cast<double>(m_memory.size()) / static_cast<double>(m_measurements);
    return static_cast<std::uint64_t>(static_cast<double>(m_steps) * (kWarmUp + (1.0 - kWarmUp) * share));
}

PlayerState Soak::step(const PlayedViewer& viewer) {
    const auto& [window, session, model, places, area, capture] = viewer;
    if (!m_home) {
        m_home = Home{.settings = model.settings, .size = window.currentSize()};
    }
    if (m_phase != Phase::playing) {
        measure(window, session, model);
    } else if (session.isReady() && model.picture.shown != nullptr) {
        if (m_done >= stepsBeforeRest()) {
            rest(window, session, model);
        } else {
            play(viewer);
            ++m_done;
        }
    } else {
        return PlayerState::waits;
    }
    return isDone() ? PlayerState::quits : PlayerState::plays;
}

double Soak::Change::percent() const {
    return warm > 0 ? 100.0 * (static_cast<double>(end) / static_cast<double>(warm) - 1.0) : 0.0;
}

Soak::Change Soak::changeOf(std::uint64_t Memory::*bytes) const {
    const auto least = [&](auto first) {
        const auto found = std::min_element(
            first, first + kCompared, [&](const Memory& a, const Memory& b) { return a.*bytes < b.*bytes; });
        return (*found).*bytes;
    };
    return {.warm = least(m_memory.begin()), .end = least(m_memory.end() - kCompared)};
}

std::optional<double> Soak::growth() const {
    if (!isDone()) {
        return std::nullopt;
    }
    return std::max(changeOf(&Memory::allocated).percent(), changeOf(&Memory::resident).percent());
}

/// "48.1 MB after warm-up and 48.2 MB at the end (+0.21 %)"
std::string Soak::growthOf(std::uint64_t Memory::*bytes) const {
    const Change change = changeOf(bytes);
    return fmt::format("{:.1f} MB after warm-up and {:.1f} MB at the end ({:+.2f} %)", megabytes(change.warm),
                       megabytes(change.end), change.percent());
}

std::string Soak::report() const {
    if (!isDone()) {
        return fmt::format("soak: ended after {} of {} steps", m_done, m_steps);
    }
    return fmt::format(
        "soak: {} steps, {} frames rendered; allocated {}, resident {}, before the device was made "
        "anew {}, each the least of {} measurements",
        m_done, m_results, growthOf(&Memory::allocated), growthOf(&Memory::resident),
        growthOf(&Memory::before), kCompared);
}

} // namespace cdr::viewer
