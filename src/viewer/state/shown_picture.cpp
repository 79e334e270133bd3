#include "shown_picture.h"

#include "command_line.h"
#include "split_picture.h"

#include <fmt/format.h>

namespace cdr::viewer {

image::ImageRgba8 shownPicture(const RenderResult* shown, double divider) {
    if (shown == nullptr || shown->sides.empty()) {
        return {};
    }
    const auto& sides = shown->sides;
    if (sides.size() == 1) {
        return *sides.front().picture;
    }
    image::ImageRgba8 picture;
    composeSplit(*sides[0].picture, *sides[1].picture, divider, picture);
    return picture;
}

std::string commandLinesOf(const PictureModel& picture) {
    if (picture.shown == nullptr || picture.shown->sides.empty()) {
        return {};
    }
    const RenderResult& shown = *picture.shown;
    const bool isSplit = shown.sides.size() > 1;
    std::string lines;
    for (std::size_t side = 0; side < shown.sides.size(); ++side) {
        const ReproducedView view{
            .settings = shown.settings,
            .side = side,
            .camera = shown.camera,
            .sceneCamera = shown.scene->setup.path.at(shown.frame),
            .extent = {shown.sides[side].options.width, shown.sides[side].options.height},
            .frame = shown.frame,
            .device = picture.device};
        const char* name = side == 0 ? "left.png" : "right.png";
        lines += fmt::format("{}{}", side == 0 ? "" : "\n", renderCommand(view, isSplit ? name : "view.png"));
    }
    return lines;
}

} // namespace cdr::viewer
