#include "panels.h"

#include <viewer/state/help_text.h>

#include <imgui.h>

#include <functional>

namespace cdr::viewer {

namespace {

void drawTab(const char* name, ItemPlaces& places, const std::function<void()>& body) {
    const bool isOpen = ImGui::BeginTabItem(name);
    places.note(name);
    if (!isOpen) {
        return;
    }
    ImGui::BeginChild(name);
    body();
    ImGui::EndChild();
    ImGui::EndTabItem();
}

} // namespace

void drawSidebar(const Widgets& widgets, ItemPlaces& places, float width, ViewerModel& model) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x - width, 0.0f});
    ImGui::SetNextWindowSize({width, window.y});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
    if (ImGui::BeginTabBar("tabs")) {
        drawTab("Look", places, [&] {
            drawScenePanel(widgets, model);
            drawTechniquePanel(widgets, model);
            drawViewPanel(widgets, model);
        });
        drawTab("Camera", places, [&] {
            drawCameraPanel(widgets, model);
            drawMeasuringPanel(widgets, model);
        });
        drawTab("Draw", places, [&] {
            drawRenderingPanel(widgets, model);
            drawFinishPanel(widgets, model);
        });
        drawTab("Frame", places, [&] {
            drawFrameGraph(widgets, model);
            widgets.checkbox("render though nothing changes", model.rendersAlways);
            drawTimeline(widgets, model);
        });
        drawTab("Inside", places, [&] {
            drawCascadesPanel(widgets, model);
            drawMemoryPanel(widgets, model);
        });
        ImGui::EndTabBar();
    }
    ImGui::End();
}

void drawHelp(ViewerModel& model) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2.0f, window.y / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {window.x * 0.9f, window.y * 0.9f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f);
    ImGui::Begin("Help", &model.showsHelp,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings);
    for (const HelpSection& section : helpText()) {
        ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%.*s",
                           static_cast<int>(section.title.size()), section.title.data());
        for (const HelpLine& line : section.lines) {
            ImGui::TextUnformatted(line.keys.data(), line.keys.data() + line.keys.size());
            ImGui::SameLine(ImGui::GetFontSize() * 11.0f);
            ImGui::TextDisabled("%.*s", static_cast<int>(line.meaning.size()), line.meaning.data());
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

} // namespace cdr::viewer
