#include "panels.h"
#include "shortcuts.h"

#include <imgui.h>

#include <cstddef>
#include <functional>

namespace cdr::viewer {

namespace {

/// A panel's contents, whose items the arrow keys reach together with the rest of the window.
bool beginPanel(const char* name) {
#if IMGUI_VERSION_NUM < 19100
    return ImGui::BeginChild(name, {0.0f, 0.0f}, false, ImGuiWindowFlags_NavFlattened);
#else
    return ImGui::BeginChild(name, {0.0f, 0.0f}, ImGuiChildFlags_NavFlattened);
#endif
}

void drawTab(std::size_t panel, ItemPlaces& places, std::optional<PanelKeys>& keys,
             const std::function<void()>& body) {
    const char* name = kPanels.at(panel);
    const bool isAsked = keys && keys->panel == panel && !keys->isOpened;
    const bool isOpen =
        ImGui::BeginTabItem(name, nullptr, isAsked ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    places.note(name);
    if (!isOpen) {
        return;
    }
    if (isAsked) {
        ImGui::SetNextWindowFocus();
        keys->isOpened = true;
    }
    beginPanel(name);
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
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    const RenderResult* result = model.picture.shown.get();
    std::optional<PanelKeys>& keys = model.interface.panelKeys;
    if (ImGui::BeginTabBar("tabs")) {
        drawTab(0, places, keys, [&] {
            drawScenePanel(widgets, result, model.settings);
            drawTechniquePanel(widgets, model.settings);
            drawViewPanel(widgets, model.settings);
            drawEyesPanel(widgets, model);
        });
        drawTab(1, places, keys, [&] {
            drawAnimationPanel(widgets, result, model.settings, model.camera.playback);
            drawCameraPanel(widgets, model);
            drawMeasuringPanel(widgets, model);
            drawLayersPanel(widgets, model.picture, model.settings);
        });
        drawTab(2, places, keys, [&] {
            drawRenderingPanel(widgets, model.settings);
            drawFinishPanel(widgets, model.settings);
        });
        drawTab(3, places, keys, [&] {
            drawFrameGraph(widgets, model.performance);
            widgets.checkbox("render without pause", model.performance.rendersAlways);
            drawTimeline(widgets, result);
        });
        drawTab(4, places, keys, [&] {
            drawCascadesPanel(widgets, result, model.interface.unit);
            drawMemoryPanel(widgets, result, model.performance);
        });
        ImGui::EndTabBar();
    }
    ImGui::End();
}

void drawHelp(InterfaceModel& interface) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2.0f, window.y / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {window.x * 0.9f, window.y * 0.9f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f);
    // All lines fit a window of 720 rows.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {ImGui::GetStyle().ItemSpacing.x, 0.05f * ImGui::GetFontSize()});
    ImGui::Begin("Help", &interface.showsHelp,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushTextWrapPos(0.9f * window.x - 2.0f * ImGui::GetFontSize() - ImGui::GetStyle().ScrollbarSize);
    for (const ShortcutSection& section : shortcuts()) {
        ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%.*s",
                           static_cast<int>(section.title.size()), section.title.data());
        for (const Shortcut& line : section.shortcuts) {
            ImGui::TextUnformatted(line.keys.data(), line.keys.data() + line.keys.size());
            ImGui::SameLine(ImGui::GetFontSize() * 11.0f);
            ImGui::TextDisabled("%.*s", static_cast<int>(line.meaning.size()), line.meaning.data());
        }
    }
    ImGui::PopTextWrapPos();
    interface.hiddenHelp = ImGui::GetScrollMaxY();
    ImGui::End();
    ImGui::PopStyleVar(2);
}

} // namespace cdr::viewer
