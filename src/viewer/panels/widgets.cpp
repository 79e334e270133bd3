#include "widgets.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace cdr::viewer {

namespace {

constexpr float kLabelShare = 0.30f;  ///< of a panel's width
constexpr float kPictureWidth = 6.0f; ///< in letters' heights
constexpr float kPictureShape = 9.0f / 16.0f;
/// Of a slider's numbers. Dear ImGui ends the program where an end is beyond half of the largest float.
constexpr double kLargest = 1e38;

float shownBySlider(double value) {
    return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

void text(std::string_view words) {
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
}

void text(std::string_view words, ImGuiCol color) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(color));
    text(words);
    ImGui::PopStyleColor();
}

bool isEscapePressed() {
#if IMGUI_VERSION_NUM >= 18700
    return ImGui::IsKeyPressed(ImGuiKey_Escape);
#else
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
#endif
}

} // namespace

void Widgets::heading(std::string_view words) const {
    ImGui::Dummy({0.0f, ImGui::GetStyle().ItemSpacing.y * 0.5f});
    text(words, ImGuiCol_CheckMark);
}

void Widgets::sentence(std::string_view words) const {
    ImGui::PushTextWrapPos(0.0f);
    text(words, ImGuiCol_TextDisabled);
    ImGui::PopTextWrapPos();
}

void Widgets::value(std::string_view name, const std::string& words) const {
    text(name, ImGuiCol_TextDisabled);
    ImGui::SameLine(ImGui::GetContentRegionMax().x * kLabelShare);
    ImGui::PushTextWrapPos(0.0f);
    text(words);
    ImGui::PopTextWrapPos();
}

bool Widgets::copied(std::string_view name, const std::string& words, const std::string& full) const {
    value(name, words);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    const ImVec2 next = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(low);
    ImGui::PushID(full.c_str());
    const bool isClicked =
        ImGui::InvisibleButton(std::string(name).c_str(), {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
    ImGui::PopID();
    m_places.note(name);
    if (ImGui::IsItemHovered() || ImGui::IsItemFocused()) {
        ImGui::SetTooltip("copies %s", full.c_str());
    }
    if (isClicked) {
        ImGui::SetClipboardText(full.c_str());
    }
    ImGui::SetCursorScreenPos(next);
    return isClicked;
}

void Widgets::label(std::string_view name) const {
    ImGui::AlignTextToFramePadding();
    // The part before a slash makes the name unique, and is not shown.
    text(name.substr(name.find('/') + 1), ImGuiCol_TextDisabled);
    ImGui::SameLine(ImGui::GetContentRegionMax().x * kLabelShare);
    ImGui::SetNextItemWidth(-1.0f);
}

std::size_t Widgets::combo(std::string_view name, std::string_view shown, std::size_t count,
                           const std::function<std::string_view(std::size_t)>& nameOf,
                           const PictureOf& pictureOf) const {
    label(name);
    std::size_t chosen = count;
    const bool isOpen = ImGui::BeginCombo(fmt::format("##{}", name).c_str(), std::string(shown).c_str(),
                                          ImGuiComboFlags_HeightLargest);
    if (isOpen) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::string entry(nameOf(i));
            const float side = pictureOf ? kPictureWidth * ImGui::GetFontSize() : 0.0f;
            ImGui::PushID(static_cast<int>(i)); // entries of files may have equal names
            ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0f, 0.5f});
            if (pictureOf) {
                pictureOf(i, side);
                ImGui::SameLine();
            }
            if (ImGui::Selectable(entry.c_str(), entry == shown, ImGuiSelectableFlags_None,
                                  {0.0f, side * kPictureShape})) {
                chosen = i;
            }
            ImGui::PopStyleVar();
            ImGui::PopID();
            m_places.note(fmt::format("{}={}", name, entry));
        }
        if (isEscapePressed()) { // a list that the pointer opened has no keys
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndCombo();
    } else {
        m_places.note(name);
    }
    return chosen;
}

bool Widgets::button(std::string_view name) const {
    const std::string shown = fmt::format("{}##{}", name.substr(name.find('/') + 1), name);
    const bool isPressed = ImGui::Button(shown.c_str());
    m_places.note(name);
    return isPressed;
}

bool Widgets::toggle(std::string_view name, ToggleState state) const {
    const bool isOn = state == ToggleState::on;
    if (isOn) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    }
    const bool isPressed = button(name);
    if (isOn) {
        ImGui::PopStyleColor(2);
    }
    return isPressed;
}

bool Widgets::checkbox(std::string_view name, bool& isOn) const {
    const bool isChanged = ImGui::Checkbox(std::string(name).c_str(), &isOn);
    m_places.note(name);
    return isChanged;
}

bool Widgets::count(std::string_view name, int& value, int low, int high) const {
    label(name);
    const bool isChanged = ImGui::SliderInt(fmt::format("##{}", name).c_str(), &value, low, high, "%d",
                                            ImGuiSliderFlags_AlwaysClamp);
    m_places.note(name);
    return isChanged;
}

bool Widgets::slider(std::string_view name, double& value, const SliderRange& range) const {
    float shown = shownBySlider(value);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", std::string(name).c_str());
    ImGui::SameLine(ImGui::GetFontSize() * 4.0f);
    ImGui::SetNextItemWidth(-1.0f);
    const ImGuiSliderFlags scale = range.isLogarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    const bool isMoved =
        ImGui::SliderFloat(fmt::format("##{}", name).c_str(), &shown, shownBySlider(range.low),
                           shownBySlider(range.high), range.format, ImGuiSliderFlags_AlwaysClamp | scale);
    m_places.note(name);
    // What is typed may be an expression, and 0 * 1e39 is no number.
    if (!isMoved || !std::isfinite(shown)) {
        return false;
    }
    value = std::clamp(static_cast<double>(shown), range.low, range.high);
    return true;
}

bool Widgets::number(std::string_view name, float& value) const {
    label(name);
    const bool isChanged = ImGui::InputFloat(fmt::format("##{}", name).c_str(), &value, 0.0f, 0.0f, "%.6g",
                                             ImGuiInputTextFlags_AutoSelectAll);
    m_places.note(name);
    return isChanged;
}

void Widgets::beside() const {
    ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
}

std::uint32_t packed(const image::Rgba8& color, std::uint8_t alpha) {
    return IM_COL32(color[0], color[1], color[2], alpha);
}

} // namespace cdr::viewer
