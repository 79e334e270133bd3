#include "state_line.h"

#include <cdr/base/enum_names.h>
#include <viewer/state/command_line.h>
#include <viewer/state/technique_label.h>

#include <fmt/format.h>

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
        nameOf(settings.targets), settings.threads, settings.divider, scene::degreesOf(model.camera.fovY),
        model.orbits ? 1 : 0, kMotions.nameOf(model.motion), nameOf(settings.colours),
        exactText(model.camera.position));
    if (model.shown != nullptr && !model.shown->sides.empty()) {
        const SideResult& side = model.shown->sides.front();
        line += fmt::format(" shown={} size={}x{} cascades={} draws={}", model.shown->sceneName,
                            side.options.width, side.options.height, side.frame->cascades.size(),
                            side.frame->stats.draws);
        if (side.wrong) {
            line += fmt::format(" wrong={}", side.wrong->wrong);
        }
        if (side.flipsNow) {
            line += fmt::format(" flips={} flipped={}", *side.flipsNow, side.flippedPixels);
        }
    }
    if (const auto& clicked = model.clickedCamera) {
        line += fmt::format(" clicked-from={} clicked-along={}", exactText(clicked->position),
                            exactText(-clicked->back));
    }
    line += fmt::format(" pivot={}", exactText(model.pivot));
    if (const auto& point = model.underCursor.front()) {
        line += fmt::format(" under=\"{}\"", describe(*point, model.unit));
    }
    if (const auto& picked = model.measuring.first()) {
        line += fmt::format(" picked=\"{}\" picked-at={}", describe(*picked, model.unit),
                            exactText(picked->position));
    }
    if (model.measuring.second()) {
        line += fmt::format(" measured=\"{}\"", describe(*model.measuring.span(), model.unit));
    }
    if (model.showsHelp) {
        line += fmt::format(" hidden-help={}", model.hiddenHelp);
    }
    return line + fmt::format(" notice=\"{}\"", model.notice.text);
}

} // namespace cdr::viewer
