#include "panels.h"
#include "shortcuts.h"

#include <viewer/state/camera/lens_zoom.h>
#include <viewer/state/command_line.h>
#include <viewer/state/length_text.h>

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace cdr::viewer {

namespace {

void chooseMotion(const Widgets& widgets, ViewerModel& model) {
    if (widgets.button("scene's path", model.motion == Motion::scenePath)) {
        model.motion = model.motion == Motion::scenePath ? Motion::free : Motion::scenePath;
    }
    widgets.beside();
    const bool isRecording = model.recorder.isRecording();
    if (widgets.button(isRecording ? "stop recording" : "record", isRecording)) {
        model.actions.push_back(Action::record);
    }
    if (!model.recorder.recording().cameras.empty() && !isRecording) {
        widgets.beside();
        if (widgets.button("play", model.motion == Motion::recording)) {
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
    if (widgets.button("of the window")) {
        model.actions.push_back(Action::screenshotWindow);
    }
    widgets.beside();
    if (widgets.button(model.video != nullptr ? "stop video" : "video", model.video != nullptr)) {
        model.actions.push_back(Action::video);
    }
}

} // namespace

void drawCameraPanel(const Widgets& widgets, ViewerModel& model) {
    widgets.heading("Camera");
    if (widgets.button("fly", !model.orbits)) {
        setOrbiting(model, false);
    }
    widgets.beside();
    if (widgets.button("orbit", model.orbits)) {
        setOrbiting(model, true);
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("lens");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    auto degrees = static_cast<float>(scene::degreesOf(model.camera.fovY));
    if (ImGui::SliderFloat("##lens", &degrees, static_cast<float>(kNarrowestDegrees),
                           static_cast<float>(kWidestDegrees), "%.4g degrees",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp) &&
        model.hasCamera) {
        model.camera = scene::canonical(setLens(model.camera, degrees));
    }
    widgets.value("position", exactText(model.camera.position));
    widgets.value("range", fmt::format("{} to {}", lengthText(model.camera.nearView),
                                       lengthText(model.camera.farView)));
    chooseMotion(widgets, model);
}

void drawMeasuringPanel(const Widgets& widgets, ViewerModel& model) {
    widgets.heading("Picked");
    const auto& first = model.measuring.first();
    if (!first) {
        widgets.sentence(
            "Click an object to see what it is and where; click another to measure between them.");
        return;
    }
    const auto show = [&](const PickedPoint& point) {
        widgets.value("object", point.name);
        widgets.value("position", exactText(point.position));
        widgets.value("distance", lengthText(point.distanceView, point.stepView));
        widgets.value("step", stepText(point.stepView));
    };
    show(*first);
    if (const auto& second = model.measuring.second()) {
        ImGui::Separator();
        show(*second);
        ImGui::Separator();
        widgets.value("between", describe(*model.measuring.span()));
    }
    if (widgets.button("forget")) {
        model.actions.push_back(Action::forgetMeasuring);
    }
}

} // namespace cdr::viewer
