#include "panels.h"

#include <cdr/base/quantity_text.h>
#include <viewer/state/camera/stereo_view.h>

#include <array>
#include <string_view>

namespace cdr::viewer {

namespace {

constexpr std::array<std::string_view, 3> kEyesNames{"one", "side-by-side", "anaglyph"};

std::string_view eyesName(const std::optional<options::StereoPicture>& picture) {
    return picture ? nameOf(*picture) : kEyesNames[0];
}

} // namespace

void drawEyesPanel(const Widgets& widgets, ViewerModel& model) {
    widgets.heading("Eyes");
    ViewSettings& settings = model.settings;
    const LookedAt at{.surfaceView = model.camera.surfaceView, .fovY = model.camera.now.fovY};
    const auto now = stereoPictureOf(settings);
    const std::size_t chosen =
        widgets.combo("eyes", eyesName(now), kEyesNames.size(), [](std::size_t i) { return kEyesNames[i]; });
    if (chosen < kEyesNames.size()) {
        const auto wanted = chosen == 0 ? std::nullopt : std::optional(options::kStereoPictures[chosen - 1]);
        settings = withStereo(std::move(settings), wanted, at);
    }
    widgets.sentence(explanationOf(stereoPictureOf(settings)));
    if (!stereoPictureOf(settings)) {
        return;
    }
    for (const scene::StereoMode mode : scene::kStereoModes) {
        if (mode != scene::kStereoModes.front()) {
            widgets.beside();
        }
        if (widgets.toggle(nameOf(mode), onIf(settings.views.stereo == mode))) {
            settings = withEyes(std::move(settings), mode, at);
        }
    }
    widgets.beside();
    if (widgets.button("fit to what is looked at")) {
        fitEyes(settings, at);
    }
    const base::LengthUnit unit = model.interface.unit;
    widgets.value("apart", base::quantityText(settings.views.eyeDistance.value_or(0.0), unit));
    widgets.value("meet at", settings.views.converge ? base::quantityText(*settings.views.converge, unit)
                                                     : std::string("infinity"));
}

} // namespace cdr::viewer
