#include "panels.h"

#include <cdr/base/quantity_text.h>
#include <viewer/state/plain_words.h>
#include <viewer/state/view_picture.h>

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace cdr::viewer {

namespace {

/// Of FrameStage, in order: CPU stages cool, the device warm, what the viewer adds grey.
constexpr std::array<ImU32, kFrameStages.size()> kStageColors{
    IM_COL32(94, 129, 172, 255),  IM_COL32(129, 161, 193, 255), IM_COL32(136, 192, 208, 255),
    IM_COL32(163, 190, 140, 255), IM_COL32(208, 135, 112, 255), IM_COL32(180, 142, 173, 255),
    IM_COL32(110, 118, 132, 255)};

constexpr float kGraphHeight = 96.0f; ///< in letters' scale of 15

float letters(float pixelsAt15) {
    return pixelsAt15 * ImGui::GetFontSize() / 15.0f;
}

/// A little square in a colour, then the text.
void legend(ImU32 color, std::string_view text) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFontSize() * 0.6f;
    const float top = at.y + (ImGui::GetTextLineHeight() - side) / 2.0f;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + side, top + side}, color, 2.0f);
    ImGui::Dummy({side + letters(4.0f), ImGui::GetTextLineHeight()});
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void drawBars(const FrameStatistics& statistics, const ImVec2& low, const ImVec2& size, float mostMs) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const std::size_t frames = statistics.frames();
    const std::size_t ring = statistics.totalRing().size();
    const float width = size.x / static_cast<float>(ring);
    for (std::size_t i = 0; i < frames; ++i) {
        const std::size_t at = (statistics.oldest() + i) % ring;
        const float x = low.x + size.x - static_cast<float>(frames - i) * width;
        float bottom = low.y + size.y;
        for (std::size_t stage = 0; stage < kFrameStages.size(); ++stage) {
            const float height = statistics.ring(kFrameStages[stage])[at] / mostMs * size.y;
            const float top = std::max(bottom - height, low.y);
            if (bottom - top > 0.2f) {
                draw.AddRectFilled({x, top}, {x + std::max(width, 1.0f), bottom}, kStageColors[stage]);
            }
            bottom = top;
        }
    }
}

void drawStageTable(const FrameStatistics& statistics) {
    constexpr int kColumns = 5;
    if (!ImGui::BeginTable("stages", kColumns, ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    for (const char* name : {"ms", "last", "p50", "p95", "p99"}) {
        ImGui::TableSetupColumn(name);
    }
    ImGui::TableHeadersRow();
    const auto row = [](const StageSummary& summary) {
        for (const float ms : {summary.last, summary.median, summary.p95, summary.p99}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(base::quantityText(static_cast<double>(ms)).c_str());
        }
    };
    for (std::size_t i = 0; i < kFrameStages.size(); ++i) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        legend(kStageColors[i], nameOf(kFrameStages[i]));
        row(statistics.summary(kFrameStages[i]));
    }
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("all");
    row(statistics.total());
    ImGui::EndTable();
}

void drawTracks(const WorkerTimeline& timeline) {
    const float rowHeight = ImGui::GetTextLineHeight() * 1.2f;
    const float nameWidth = letters(74.0f);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = std::max(ImGui::GetContentRegionAvail().x - nameWidth, 1.0f);
    const double scale = timeline.lengthMs > 0.0 ? width / timeline.lengthMs : 0.0;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto bar = [&](std::size_t row, double beginMs, double endMs, ImU32 color) {
        const float top = low.y + static_cast<float>(row) * rowHeight;
        const float left = low.x + nameWidth + static_cast<float>(beginMs * scale);
        const float right = std::max(low.x + nameWidth + static_cast<float>(endMs * scale), left + 1.0f);
        draw.AddRectFilled({left, top + 1.0f}, {right, top + rowHeight - 1.0f}, color, 2.0f);
        return ImGui::IsMouseHoveringRect({left, top}, {right, top + rowHeight});
    };
    const auto name = [&](std::size_t row, const std::string& text) {
        draw.AddText({low.x, low.y + static_cast<float>(row) * rowHeight},
                     ImGui::GetColorU32(ImGuiCol_TextDisabled), text.c_str());
    };
    name(0, "stages");
    for (const TimelineStage& stage : timeline.stages) {
        const auto known = std::find_if(kFrameStages.begin(), kFrameStages.end(),
                                        [&](FrameStage each) { return nameOf(each) == stage.name; });
        const auto color = known == kFrameStages.end() ? kStageColors.back()
                                                       : kStageColors[static_cast<std::size_t>(*known)];
        if (bar(0, stage.beginMs, stage.endMs, color)) {
            ImGui::SetTooltip("%s: %s", stage.name.c_str(),
                              millisecondsText(stage.endMs - stage.beginMs).c_str());
        }
    }
    for (std::size_t worker = 0; worker < timeline.workers; ++worker) {
        name(worker + 1, fmt::format("worker {}", worker));
    }
    for (const TimelineJob& job : timeline.jobs) {
        const ImU32 color = job.cascade ? packed(cascadeColor(*job.cascade)) : kStageColors[0];
        if (bar(job.worker + 1, job.beginMs, job.endMs, color)) {
            const std::string what =
                job.cascade ? fmt::format("cascade {}, {} draws", *job.cascade, job.draws) : "cull or bin";
            ImGui::SetTooltip("%s: %s", what.c_str(), millisecondsText(job.endMs - job.beginMs).c_str());
        }
    }
    ImGui::Dummy({nameWidth + width, static_cast<float>(timeline.workers + 1) * rowHeight});
}

} // namespace

void drawFrameGraph(const Widgets& widgets, const PerformanceModel& performance) {
    widgets.heading("Frame");
    const StageSummary total = performance.statistics.total();
    widgets.value("rendered",
                  fmt::format("{} frames a second, {}", base::quantityText(performance.framesPerSecond),
                              millisecondsText(static_cast<double>(total.last))));
    widgets.value("interface", millisecondsText(performance.uiFrameMs) + " a frame");
    const float mostMs = std::max(total.max, 1.0f);
    widgets.value("highest", millisecondsText(static_cast<double>(mostMs)));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, letters(kGraphHeight)};
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + size.x, low.y + size.y},
                                              ImGui::GetColorU32(ImGuiCol_FrameBg), 4.0f);
    drawBars(performance.statistics, low, size, mostMs);
    ImGui::Dummy(size);
    drawStageTable(performance.statistics);
}

void drawTimeline(const Widgets& widgets, const RenderResult* result) {
    widgets.heading("What each thread did");
    if (result == nullptr) {
        return;
    }
    for (const SideResult& side : result->sides) {
        widgets.sentence(fmt::format("{}, {}; jobs in their cascades' colours",
                                     nameOf(side.options.technique),
                                     millisecondsText(side.timeline.lengthMs)));
        drawTracks(side.timeline);
    }
}

} // namespace cdr::viewer
