#include "state_line.h"

#include <cdr/base/enum_names.h>
#include <viewer/state/camera/stereo_view.h>
#include <viewer/state/command_line.h>
#include <viewer/state/technique_label.h>

#include <fmt/format.h>
#include <options/layer_text.h>

namespace cdr::viewer {

namespace {

constexpr base::EnumNames<Motion, 4> kMotions{"motion", {"free", "scene-path", "recording", "tour"}};

} // namespace

std::string stateLine(const ViewerModel& model) {
    const ViewSettings& settings = model.settings;
    std::string line = fmt::format(
        "scene={} technique={} second={} view={} targets={} threads={} divider={:.4f} fov={:.6g} orbits={} "
        "motion={} colours={} eye={}",
        settings.scene, techniqueName(settings.technique),
        settings.second ? techniqueName(*settings.second) : "none", nameOf(settings.view),
        nameOf(settings.drawing.targets), settings.drawing.threads, settings.divider,
        scene::degreesOf(model.camera.now.fovY), model.camera.orbits ? 1 : 0,
        kMotions.nameOf(model.camera.motion), nameOf(settings.colours), exactText(model.camera.now.position));
    if (const auto eyes = stereoPictureOf(settings)) {
        line +=
            fmt::format(" eyes={} stereo={} apart={} meet={}", nameOf(*eyes), nameOf(*settings.views.stereo),
                        settings.views.eyeDistance.value_or(0.0), settings.views.converge.value_or(0.0));
    }
    for (const scenes::LayerChoice& layer : settings.layers) {
        line += fmt::format(" layer=\"{}\"", options::textOf(layer));
    }
    if (model.picture.shown != nullptr && !model.picture.shown->sides.empty()) {
        const SideResult& side = model.picture.shown->sides.front();
        line += fmt::format(" shown={} size={}x{} cascades={} draws={}", model.picture.shown->sceneName,
                            side.options.width, side.options.height, side.frame->cascades.size(),
                            side.frame->stats.draws);
        if (side.wrong) {
            line += fmt::format(" wrong={}", side.wrong->wrong);
        }
        if (side.flipsNow) {
            line += fmt::format(" flips={} flipped={}", *side.flipsNow, side.flippedPixels);
        }
    }
    if (settings.choice.framesPerSecond) {
        line += fmt::format(" time={:.6g}", model.camera.playback.moment(settings.choice));
    }
    if (const auto& clicked = model.picture.clickedCamera) {
        line += fmt::format(" clicked-from={} clicked-along={}", exactText(clicked->position),
                            exactText(-clicked->back));
    }
    line += fmt::format(" pivot={}", exactText(model.camera.pivot));
    if (const auto& point = model.picture.underCursor.front()) {
        line += fmt::format(" under=\"{}\"", describe(*point, model.interface.unit));
    }
    if (const auto& picked = model.picture.measuring.first()) {
        line += fmt::format(" picked=\"{}\" picked-at={}", describe(*picked, model.interface.unit),
                            exactText(picked->position));
    }
    if (model.picture.measuring.second()) {
        line +=
            fmt::format(" measured=\"{}\"", describe(*model.picture.measuring.span(), model.interface.unit));
    }
    if (model.interface.showsHelp) {
        line += fmt::format(" hidden-help={}", model.interface.hiddenHelp);
    }
    return line + fmt::format(" notice=\"{}\"", model.interface.notice.text);
}

} // namespace cdr::viewer
