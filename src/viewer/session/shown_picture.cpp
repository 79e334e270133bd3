#include "shown_picture.h"

#include <viewer/state/command_line.h>
#include <viewer/state/split_picture.h>
#include <viewer/state/technique_label.h>

#include <fmt/format.h>

namespace cdr::viewer {

image::ImageRgba8 shownPicture(const ViewerModel& model) {
    if (model.shown == nullptr || model.shown->sides.empty()) {
        return {};
    }
    const auto& sides = model.shown->sides;
    if (sides.size() == 1) {
        return *sides.front().picture;
    }
    image::ImageRgba8 picture;
    composeSplit(*sides[0].picture, *sides[1].picture, model.settings.divider, picture);
    return picture;
}

namespace {

std::string_view nameOf(Motion motion) {
    switch (motion) {
    case Motion::scenePath:
        return "scene-path";
    case Motion::recording:
        return "recording";
    case Motion::free:
        break;
    }
    return "free";
}

} // namespace

std::string stateLine(const ViewerModel& model) {
    const ViewSettings& settings = model.settings;
    std::string line = fmt::format(
        "scene={} technique={} second={} view={} targets={} threads={} divider={:.4f} fov={:.6g} orbits={} "
        "motion={} eye={}",
        settings.scene, techniqueName(settings.technique),
        settings.second ? techniqueName(*settings.second) : "none", nameOf(settings.view),
        nameOf(settings.targets), settings.threads, settings.divider, scene::degreesOf(model.camera.fovY),
        model.orbits ? 1 : 0, nameOf(model.motion), exactText(model.camera.position));
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
        line += fmt::format(" under=\"{}\"", describe(*point));
    }
    if (const auto& picked = model.measuring.first()) {
        line += fmt::format(" picked=\"{}\" picked-at={}", describe(*picked), exactText(picked->position));
    }
    if (model.measuring.second()) {
        line += fmt::format(" measured=\"{}\"", describe(*model.measuring.span()));
    }
    return line + fmt::format(" notice=\"{}\"", model.notice.text);
}

std::string commandLinesOf(const ViewerModel& model) {
    if (model.shown == nullptr || model.shown->sides.empty()) {
        return {};
    }
    const RenderResult& shown = *model.shown;
    const bool isSplit = shown.sides.size() > 1;
    std::string lines;
    for (std::size_t side = 0; side < shown.sides.size(); ++side) {
        const ReproducedView view{
            .settings = shown.settings,
            .side = side,
            .camera = shown.camera,
            .sceneCamera = model.sceneCamera,
            .extent = {shown.sides[side].options.width, shown.sides[side].options.height}};
        const char* name = side == 0 ? "left.png" : "right.png";
        lines += fmt::format("{}{}", side == 0 ? "" : "\n", renderCommand(view, isSplit ? name : "view.png"));
    }
    return lines;
}

} // namespace cdr::viewer
