#include "shown_picture.h"

#include "command_line.h"
#include "split_picture.h"

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
            .extent = {shown.sides[side].options.width, shown.sides[side].options.height},
            .frame = shown.frame};
        const char* name = side == 0 ? "left.png" : "right.png";
        lines += fmt::format("{}{}", side == 0 ? "" : "\n", renderCommand(view, isSplit ? name : "view.png"));
    }
    return lines;
}

} // namespace cdr::viewer
