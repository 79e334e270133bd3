#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace cdr::viewer {

/// Where the interface's items were last drawn, so that a script can click what it knows by name.
class ItemPlaces {
  public:
    struct Place {
        float x = 0.0f; ///< centre, screen coordinates of the window
        float y = 0.0f;
        bool isInView = false; ///< its centre is not scrolled out of its panel
    };

    /// A new frame: what was noted two frames ago and not since is gone.
    void beginFrame() { ++m_frame; }
    /// The last Dear ImGui item.
    void note(std::string_view name);
    std::optional<Place> find(std::string_view name) const;
    /// Scrolls the item's panel, once it is drawn next, so that the item comes into view.
    void reveal(std::string_view name) { m_revealed = name; }

  private:
    struct Noted {
        Place place;
        unsigned long frame = 0;
    };
    std::map<std::string, Noted, std::less<>> m_places;
    unsigned long m_frame = 0;
    std::optional<std::string> m_revealed; ///< by the next note()
};

} // namespace cdr::viewer
