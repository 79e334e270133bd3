#include "item_places.h"

#include <imgui.h>

namespace cdr::viewer {

void ItemPlaces::note(std::string_view name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    m_places.insert_or_assign(std::string(name),
                              Noted{{(low.x + high.x) / 2.0f, (low.y + high.y) / 2.0f}, m_frame});
}

std::optional<ItemPlaces::Place> ItemPlaces::find(std::string_view name) const {
    const auto found = m_places.find(name);
    if (found == m_places.end() || found->second.frame + 1 < m_frame) {
        return std::nullopt;
    }
    return found->second.place;
}

} // namespace cdr::viewer
