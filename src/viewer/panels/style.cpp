#include "style.h"

#include <imgui.h>

namespace cdr::viewer {

namespace {

ImVec4 rgb(unsigned hex, float alpha = 1.0f) {
    return {static_cast<float>(hex >> 16U & 0xffU) / 255.0f, static_cast<float>(hex >> 8U & 0xffU) / 255.0f,
            static_cast<float>(hex & 0xffU) / 255.0f, alpha};
}

constexpr unsigned kGround = 0x16181c;
constexpr unsigned kRaised = 0x22262d;
constexpr unsigned kHovered = 0x2e343d;
constexpr unsigned kActive = 0x3a4350;
constexpr unsigned kLine = 0x30353d;
constexpr unsigned kText = 0xd8dce3;
constexpr unsigned kQuiet = 0x8b93a0;
constexpr unsigned kAccent = 0x5aa9e6;

} // namespace

void applyStyle(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {8.0f, 4.0f};
    style.ItemSpacing = {8.0f, 6.0f};
    style.ItemInnerSpacing = {6.0f, 4.0f};
    style.ScrollbarSize = 12.0f;
    style.GrabMinSize = 10.0f;
    style.WindowRounding = 0.0f;
    style.FrameRounding = 4.0f;
    style.GrabRounding = 4.0f;
    style.PopupRounding = 4.0f;
    style.TabRounding = 4.0f;
    style.WindowBorderSize = 0.0f;
    style.PopupBorderSize = 1.0f;
    style.ScaleAllSizes(scale);

    ImVec4* colors = style.Colors;
    colors[ImGuiCol_Text] = rgb(kText);
    colors[ImGuiCol_TextDisabled] = rgb(kQuiet);
    colors[ImGuiCol_WindowBg] = rgb(kGround);
    colors[ImGuiCol_TitleBg] = rgb(kRaised);
    colors[ImGuiCol_TitleBgActive] = rgb(kRaised);
    colors[ImGuiCol_PopupBg] = rgb(kRaised, 0.98f);
    colors[ImGuiCol_Border] = rgb(kLine);
    colors[ImGuiCol_Separator] = rgb(kLine);
    colors[ImGuiCol_FrameBg] = rgb(kRaised);
    colors[ImGuiCol_FrameBgHovered] = rgb(kHovered);
    colors[ImGuiCol_FrameBgActive] = rgb(kActive);
    colors[ImGuiCol_Button] = rgb(kRaised);
    colors[ImGuiCol_ButtonHovered] = rgb(kHovered);
    colors[ImGuiCol_ButtonActive] = rgb(kActive);
    colors[ImGuiCol_Header] = rgb(kRaised);
    colors[ImGuiCol_HeaderHovered] = rgb(kHovered);
    colors[ImGuiCol_HeaderActive] = rgb(kActive);
    colors[ImGuiCol_Tab] = rgb(kGround);
    colors[ImGuiCol_TabHovered] = rgb(kHovered);
    colors[ImGuiCol_TabActive] = rgb(kRaised);
    colors[ImGuiCol_CheckMark] = rgb(kAccent);
    colors[ImGuiCol_SliderGrab] = rgb(kAccent, 0.7f);
    colors[ImGuiCol_SliderGrabActive] = rgb(kAccent);
    colors[ImGuiCol_PlotHistogram] = rgb(kAccent);
    colors[ImGuiCol_PlotLines] = rgb(kAccent);
    colors[ImGuiCol_TextSelectedBg] = rgb(kAccent, 0.35f);
    colors[ImGuiCol_ScrollbarBg] = rgb(kGround);
    colors[ImGuiCol_ScrollbarGrab] = rgb(kHovered);
    colors[ImGuiCol_TableBorderLight] = rgb(kLine);
    colors[ImGuiCol_TableBorderStrong] = rgb(kLine);
    colors[ImGuiCol_TableHeaderBg] = rgb(kGround);
    colors[ImGuiCol_TableRowBgAlt] = rgb(0xffffff, 0.02f);
    colors[ImGuiCol_NavHighlight] = rgb(kAccent);
    colors[ImGuiCol_ModalWindowDimBg] = rgb(0x000000, 0.5f);
}

} // namespace cdr::viewer
