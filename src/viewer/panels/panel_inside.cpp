#include "panels.h"

#include <viewer/state/plain_words.h>
#include <viewer/state/technique_label.h>
#include <viewer/state/view_picture.h>

#include <fmt/format.h>
#include <imgui.h>
#include <program/allocator.h>

#include <string>

namespace cdr::viewer {

namespace {

void drawCascades(const SideResult& side, base::LengthUnit unit) {
    constexpr int kColumns = 4;
    if (!ImGui::BeginTable("cascades", kColumns, ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    for (const char* name : {"near", "far", "step at far", "draws"}) {
        ImGui::TableSetupColumn(name);
    }
    ImGui::TableHeadersRow();
    const depth::Cascades& cascades = side.frame->cascades;
    const auto draws = drawsByCascade(side.timeline, cascades.size(), side.options.submission);
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        const ImVec4 color = ImGui::ColorConvertU32ToFloat4(packed(cascadeColor(i)));
        ImGui::TextColored(color, "%s", base::quantityText(cascades[i].nearView, unit).c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(base::quantityText(cascades[i].farView, unit).c_str());
        ImGui::TableNextColumn();
        // Just before the far plane, which is the next cascade's.
        const double last =
            cascades[i].nearView + (cascades[i].farView - cascades[i].nearView) * (1.0 - 1e-9);
        const double step = techniqueStepView(side.options.technique, cascades, last);
        ImGui::TextUnformatted(base::quantityText(step, unit).c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(draws ? fmt::format("{}", (*draws)[i]).c_str() : "-");
    }
    ImGui::EndTable();
}

std::string megabytes(std::uint64_t bytes) {
    constexpr double kMegabyte = 1e6;
    return base::quantityText(static_cast<double>(bytes) / kMegabyte) + "\u00a0MB";
}

} // namespace

void drawCascadesPanel(const Widgets& widgets, const RenderResult* result, base::LengthUnit unit) {
    widgets.heading("Cascades");
    if (result == nullptr) {
        return;
    }
    for (const SideResult& side : result->sides) {
        const render::FrameStats& stats = side.frame->stats;
        const std::string each = base::quantityText(stats.duplication);
        widgets.sentence(fmt::format("{}: {} visible, {}, {} draw{} for each object",
                                     nameOf(side.options.technique),
                                     base::quantityText(static_cast<double>(stats.visible)),
                                     counted(stats.draws, "draw"), each, each == "1" ? "" : "s"));
        ImGui::PushID(&side);
        drawCascades(side, unit);
        ImGui::PopID();
    }
}

void drawMemoryPanel(const Widgets& widgets, const RenderResult* result,
                     const PerformanceModel& performance) {
    widgets.heading("Memory");
    if (const auto resident = program::residentBytes()) {
        widgets.value("program", megabytes(*resident));
    }
    if (result != nullptr && !result->sides.empty()) {
        const render::RenderOptions& options = result->sides.front().options;
        const std::uint64_t pixels = std::uint64_t{options.width} * options.height;
        widgets.value("a G-buffer", megabytes(pixels * sizeof(render::GBufferPixel)));
        widgets.value("device", megabytes(result->freeDeviceBytes) + " free");
    }
    widgets.heading("Devices that draw");
    widgets.value("the scene", performance.device);
    widgets.value("the window", performance.uiDevice);
}

} // namespace cdr::viewer
