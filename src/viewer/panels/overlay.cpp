#include "overlay.h"

#include <cdr/base/quantity_text.h>
#include <cdr/scene/frustum.h>
#include <viewer/state/camera/stereo_view.h>
#include <viewer/state/plain_words.h>
#include <viewer/state/technique_label.h>
#include <viewer/state/tour.h>

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

namespace cdr::viewer {

namespace {

constexpr ImU32 kPaper = IM_COL32(18, 20, 24, 255); ///< covers the divider under a text
constexpr ImU32 kInk = IM_COL32(228, 232, 238, 255);
constexpr ImU32 kQuietInk = IM_COL32(160, 168, 180, 255);
constexpr ImU32 kMarkInk = IM_COL32(90, 169, 230, 255);
constexpr ImU32 kProblem = IM_COL32(240, 120, 100, 255);

/// The picture in Dear ImGui's coordinates.
struct Canvas {
    ImDrawList& draw;
    ImVec2 size;

    Canvas(const PictureArea& area, ImDrawList& list) : draw(list) {
        const auto units = [&](double pixels) { return static_cast<float>(pixels / area.pixelsPerUnit); };
        size = {units(area.extent.width), units(area.extent.height)};
    }
};

float gap() {
    return ImGui::GetFontSize() * 0.6f;
}

/// To which side of a place a plate grows.
enum class PlateSide : std::uint8_t { left, right };

/// Lines on a dark plate, left or right of `at`, never wider than `most`.
void plate(const Canvas& canvas, ImVec2 at, PlateSide side, float most, const std::string& title,
           const std::string& text) {
    const float inner = gap() * 0.8f;
    const float wrap = std::max(most - 2.0f * inner, ImGui::GetFontSize());
    const ImVec2 titleSize = ImGui::CalcTextSize(title.c_str(), nullptr, false, wrap);
    const ImVec2 textSize =
        text.empty() ? ImVec2(0.0f, 0.0f) : ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const ImVec2 size{std::min(std::max(titleSize.x, textSize.x), wrap) + 2.0f * inner,
                      titleSize.y + (text.empty() ? 0.0f : textSize.y + 2.0f) + 1.6f * inner};
    const ImVec2 low{side == PlateSide::left ? at.x - size.x : at.x, at.y};
    canvas.draw.AddRectFilled(low, {low.x + size.x, low.y + size.y}, kPaper, 5.0f);
    canvas.draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + inner, low.y + 0.8f * inner}, kInk,
                        title.c_str(), nullptr, wrap);
    if (!text.empty()) {
        canvas.draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                            {low.x + inner, low.y + 0.8f * inner + titleSize.y + 2.0f}, kQuietInk,
                            text.c_str(), nullptr, wrap);
    }
}

/// What a view that counts has counted; else empty.
std::string countText(ViewKind view, const SideResult& side) {
    if (view == ViewKind::wrong && side.wrong) {
        return fmt::format("{} off edges, against the anchored answer", wrongText({*side.wrong}));
    }
    if (view == ViewKind::flips && side.flipsNow) {
        return fmt::format("{} since the last frame, {} in a second", counted(*side.flipsNow, "flip"),
                           counted(side.flippedPixels, "pixel"));
    }
    return {};
}

void drawLabel(const Canvas& canvas, const PictureModel& picture, base::LengthUnit unit, std::size_t index,
               float divider) {
    const SideResult& side = picture.shown->sides[index];
    const std::string title = techniqueName(side.options.technique);
    std::string text = countText(picture.shown->settings.view, side);
    if (const auto& point = picture.underCursor.at(index)) {
        text += fmt::format("{}{}", text.empty() ? "" : "\n",
                            resolvesText(point->stepView, point->distanceView, unit));
    }
    const bool isSplit = picture.shown->sides.size() > 1;
    const float y = gap();
    const bool isLeft = index == 0;
    const float low = isLeft ? 0.0f : divider;
    const float high = isLeft && isSplit ? divider : canvas.size.x;
    const float room = high - low - 2.0f * gap();
    if (room > ImGui::GetFontSize() * 6.0f) {
        plate(canvas, {isLeft ? low + gap() : high - gap(), y}, isLeft ? PlateSide::right : PlateSide::left,
              room, title, text);
    }
}

void drawDivider(const Canvas& canvas, float x) {
    canvas.draw.AddRectFilled({x - 1.0f, 0.0f}, {x + 1.0f, canvas.size.y}, IM_COL32(236, 240, 246, 220));
    const float middle = canvas.size.y / 2.0f;
    const float radius = ImGui::GetFontSize() * 0.75f;
    canvas.draw.AddCircleFilled({x, middle}, radius, IM_COL32(236, 240, 246, 240));
    for (const float direction : {-1.0f, 1.0f}) {
        const float tip = x + direction * radius * 0.66f;
        const float foot = x + direction * radius * 0.22f;
        const float half = radius * 0.36f;
        canvas.draw.AddTriangleFilled({tip, middle}, {foot, middle - half}, {foot, middle + half},
                                      IM_COL32(40, 46, 56, 255));
    }
}

/// Where a world position is on the canvas, if the camera sees it.
std::optional<ImVec2> onCanvas(const Canvas& canvas, const scene::Camera& camera, const glm::dvec3& world) {
    const glm::dvec3 view = camera.toView(world);
    const double w = -view.z;
    if (w < camera.nearView) {
        return std::nullopt;
    }
    const double aspect = canvas.size.x / canvas.size.y;
    const scene::Frustum frustum = scene::frustumOf(camera, aspect, 1.0);
    const double x = (view.x / w - frustum.centre.x) / frustum.tanX;
    const double y = (view.y / w - frustum.centre.y) / frustum.tanY;
    if (std::abs(x) > 1.0 || std::abs(y) > 1.0) {
        return std::nullopt;
    }
    return ImVec2(static_cast<float>((x + 1.0) / 2.0) * canvas.size.x,
                  static_cast<float>((1.0 - y) / 2.0) * canvas.size.y);
}

void drawMeasuring(const Canvas& canvas, const PictureModel& picture) {
    const auto& first = picture.measuring.first();
    // Of two eyes, a place is at two places of the picture: none is marked.
    if (!first || picture.shown == nullptr || stereoPictureOf(picture.shown->settings)) {
        return;
    }
    const auto mark = [&](const PickedPoint& point) {
        const auto at = onCanvas(canvas, picture.shown->camera, point.position);
        if (at) {
            canvas.draw.AddCircle(*at, ImGui::GetFontSize() * 0.4f, kMarkInk, 0, 2.0f);
        }
        return at;
    };
    const auto from = mark(*first);
    const auto& second = picture.measuring.second();
    const auto to = second ? mark(*second) : std::nullopt;
    if (from && to) {
        canvas.draw.AddLine(*from, *to, kMarkInk, 1.5f);
    }
}

/// A line in the middle of the canvas, on a dark plate whose lower edge is at `low`. Returns its upper edge.
float drawLine(const Canvas& canvas, float low, ImU32 ink, const std::string& text) {
    const float wrap = std::max(canvas.size.x - 4.0f * gap(), ImGui::GetFontSize());
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const ImVec2 at{(canvas.size.x - size.x) / 2.0f, low - size.y - 0.6f * gap()};
    const float top = at.y - 0.6f * gap();
    canvas.draw.AddRectFilled({at.x - gap(), top}, {at.x + size.x + gap(), low}, kPaper, 5.0f);
    canvas.draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, ink, text.c_str(), nullptr, wrap);
    return top;
}

/// From the picture's lower edge up: what was clicked, how much is wrong, then what there is to say.
void drawLines(const Canvas& canvas, const ViewerModel& model) {
    float low = canvas.size.y - gap();
    const auto add = [&](ImU32 ink, const std::string& text) {
        if (!text.empty()) {
            low = drawLine(canvas, low, ink, text) - 0.5f * gap();
        }
    };
    if (const auto& first = model.picture.measuring.first()) {
        const auto span = model.picture.measuring.span();
        add(kInk, span ? fmt::format("{}\n{}", describe(*first, model.interface.unit),
                                     describe(*span, model.interface.unit))
                       : describe(*first, model.interface.unit));
    }
    add(model.picture.isWrongCurrent ? kInk : kQuietInk, wrongText(model.picture.wrong));
    add(kQuietInk, lagText(model.performance.lagSeconds));
    if (model.video) {
        add(kProblem, fmt::format("recording a video, {} s; F11 ends it",
                                  base::quantityText(std::floor(model.video->seconds()))));
    }
    if (model.camera.motion == Motion::tour) {
        add(kInk, std::string(tourCaption(scene::degreesOf(model.camera.now.fovY))));
    } else if (const auto step = model.interface.firstSteps.text()) {
        add(kMarkInk, std::string(*step));
    }
    if (model.picture.seesNothing) {
        add(kProblem, "Nothing is in view. Home brings the scene's own camera back.");
    }
    const Notice& notice = model.interface.notice;
    if (std::chrono::steady_clock::now() <= notice.until) {
        add(notice.kind == NoticeKind::problem ? kProblem : kInk, notice.text);
    }
}

} // namespace

void drawOverlay(const PictureArea& area, const ViewerModel& model) {
    const Canvas canvas(area, *ImGui::GetBackgroundDrawList());
    if (canvas.size.x < ImGui::GetFontSize() * 8.0f) {
        return;
    }
    if (model.picture.shown != nullptr) {
        const float divider = static_cast<float>(model.settings.divider) * canvas.size.x;
        if (model.picture.shown->sides.size() > 1) {
            drawDivider(canvas, divider);
        }
        for (std::size_t side = 0; side < model.picture.shown->sides.size(); ++side) {
            drawLabel(canvas, model.picture, model.interface.unit, side, divider);
        }
        drawMeasuring(canvas, model.picture);
    }
    drawLines(canvas, model);
}

} // namespace cdr::viewer
