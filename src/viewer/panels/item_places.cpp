#include "item_places.h"

#include <imgui.h>

namespace cdr::viewer {

void ItemPlaces::note(std::string_view name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const ImVec2 centre{(low.x + high.x) / 2.0f, (low.y + high.y) / 2.0f};
    const bool isInView = ImGui::IsRectVisible(centre, {centre.x + 1.0f, centre.y + 1.0f});
    m_places.insert_or_assign(std::string(name), Noted{{centre.x, centre.y, isInView}, m_frame});
    if (m_revealed == name) {
        ImGui::SetScrollHereY();
        m_revealed.reset();
    }
}

std::optional<ItemPlaces::Place> ItemPlaces::find(std::string_view name) const {
    const auto found = m_places.find(name);
    if (found == m_places.end() || found->second.frame + 1 < m_frame) {
        return std::nullopt;
    }
    return found->second.place;
}

} // namespace cdr::viewer
