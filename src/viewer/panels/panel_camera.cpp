#include "panels.h"
#include "shortcuts.h"

#include <cdr/base/number_text.h>
#include <cdr/base/quantity_text.h>
#include <viewer/state/camera/lens_zoom.h>
#include <viewer/state/command_line.h>

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string>
#include <string_view>

namespace cdr::viewer {

namespace {

std::string_view unitTitle(base::LengthUnit unit) {
    constexpr std::array<std::string_view, base::kLengthUnits.size()> kTitles{
        "scene units", "the unit that fits", "µm", "mm", "m", "km"};
    return kTitles.at(static_cast<std::size_t>(unit));
}

void sayCopied(InterfaceModel& interface, const std::string& full) {
    interface.say("copied " + full);
}

/// A place, of which a click copies what --eye takes.
void showPlace(const Widgets& widgets, InterfaceModel& interface, const glm::dvec3& place) {
    const auto text = [&](double value) { return base::quantityText(value, interface.unit); };
    const std::string full = exactText(place);
    if (widgets.copied("position", fmt::format("{}, {}, {}", text(place.x), text(place.y), text(place.z)),
                       full)) {
        sayCopied(interface, full);
    }
}

/// A length, of which a click copies all digits, in scene units.
void showLength(const Widgets& widgets, InterfaceModel& interface, std::string_view name, double metres) {
    const std::string full = base::shortest(metres);
    if (widgets.copied(name, base::quantityText(metres, interface.unit), full)) {
        sayCopied(interface, full);
    }
}

void chooseMotion(const Widgets& widgets, ViewerModel& model) {
    if (widgets.toggle("scene's path", onIf(followsPath(model.camera)))) {
        togglePath(model.camera);
    }
    widgets.beside();
    const bool isRecording = model.camera.recorder.isRecording();
    const char* record = isRecording                  ? "stop recording"
                         : model.camera.isPathUnsaved ? "save recording"
                                                      : "record";
    if (widgets.toggle(record, onIf(isRecording))) {
        model.actions.push_back(Action::record);
    }
    if (!model.camera.recorder.recording().cameras.empty() && !isRecording) {
        widgets.beside();
        if (widgets.toggle("play", onIf(model.camera.motion == Motion::recording))) {
            model.actions.push_back(Action::playRecording);
        }
    }
    if (widgets.button("scene's camera")) {
        model.actions.push_back(Action::sceneCamera);
    }
    widgets.beside();
    if (widgets.button("copy command line")) {
        model.actions.push_back(Action::copyCommandLine);
    }
    if (widgets.button("screenshot")) {
        model.actions.push_back(Action::screenshotPicture);
    }
    widgets.beside();
    if (widgets.button("screenshot of the window")) {
        model.actions.push_back(Action::screenshotWindow);
    }
    if (widgets.toggle(model.video != nullptr ? "stop video" : "video", onIf(model.video != nullptr))) {
        model.actions.push_back(Action::video);
    }
}

} // namespace

void drawCameraPanel(const Widgets& widgets, ViewerModel& model) {
    widgets.heading("Camera");
    if (widgets.toggle("fly", onIf(!model.camera.orbits))) {
        model.camera.orbits = false;
    }
    widgets.beside();
    if (widgets.toggle("orbit", onIf(model.camera.orbits))) {
        beginOrbit(model.camera, model.picture.measuring);
    }
    double degrees = scene::degreesOf(model.camera.now.fovY);
    if (widgets.slider("lens", degrees,
                       {.low = kNarrowestDegrees,
                        .high = kWidestDegrees,
                        .format = "%.4g degrees",
                        .isLogarithmic = true}) &&
        model.camera.isThere) {
        model.camera.now = scene::canonical(setLens(model.camera.now, degrees));
    }
    showPlace(widgets, model.interface, model.camera.now.position);
    widgets.value("range",
                  fmt::format("{} to {}", base::quantityText(model.camera.now.nearView, model.interface.unit),
                              base::quantityText(model.camera.now.farView, model.interface.unit)));
    const std::size_t unit =
        widgets.combo("lengths in", unitTitle(model.interface.unit), base::kLengthUnits.size(),
                      [](std::size_t i) { return unitTitle(base::kLengthUnits[i]); });
    if (unit < base::kLengthUnits.size()) {
        model.interface.unit = base::kLengthUnits[unit];
    }
    chooseMotion(widgets, model);
}

void drawMeasuringPanel(const Widgets& widgets, ViewerModel& model) {
    widgets.heading("Picked");
    const auto& first = model.picture.measuring.first();
    if (!first) {
        widgets.sentence(
            "Click an object to see what it is and where; click another to measure between them.");
        return;
    }
    const auto show = [&](const PickedPoint& point) {
        widgets.value("object", point.name);
        showPlace(widgets, model.interface, point.position);
        showLength(widgets, model.interface, "distance", point.distance);
        showLength(widgets, model.interface, "along view", point.distanceView);
        showLength(widgets, model.interface, "step", point.stepView);
    };
    show(*first);
    if (const auto& second = model.picture.measuring.second()) {
        ImGui::Separator();
        show(*second);
        ImGui::Separator();
        const Span span = *model.picture.measuring.span();
        showLength(widgets, model.interface, "between", span.length);
        showLength(widgets, model.interface, "along view", span.alongView);
        showLength(widgets, model.interface, "uncertainty", span.uncertainty);
    }
    if (widgets.button("forget")) {
        model.actions.push_back(Action::forgetMeasuring);
    }
}

} // namespace cdr::viewer
