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
    };

    /// A new frame: what was noted two frames ago and not since is gone.
    void beginFrame() { ++m_frame; }
    /// The last Dear ImGui item.
    void note(std::string_view name);
    std::optional<Place> find(std::string_view name) const;

  private:
    struct Noted {
        Place place;
        unsigned long frame = 0;
    };
    std::map<std::string, Noted, std::less<>> m_places;
    unsigned long m_frame = 0;
};

} // namespace cdr::viewer
