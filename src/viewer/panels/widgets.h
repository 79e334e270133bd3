#pragma once

#include "item_places.h"

#include <cdr/image/image.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace cdr::viewer {

/// Whether what a button stands for is on.
enum class ToggleState : std::uint8_t { off, on };

constexpr ToggleState onIf(bool isOn) {
    return isOn ? ToggleState::on : ToggleState::off;
}

/// What a slider chooses from, and how its number is printed.
struct SliderRange {
    double low = 0.0;
    double high = 1.0;
    const char* format = "%.3f"; ///< of a double, as printf() takes it
    bool isLogarithmic = false;
};

/// The interface's building blocks: Dear ImGui's, in one look, and each known to scripts by its name.
class Widgets {
  public:
    explicit Widgets(ItemPlaces& places) : m_places(places) {}

    /// A caption above a group.
    void heading(std::string_view words) const;
    /// A sentence in quiet letters, wrapped.
    void sentence(std::string_view words) const;
    /// A name in quiet letters and its value beside it.
    void value(std::string_view name, const std::string& words) const;
    /// The same of what a click copies with all its digits. @return whether it was clicked.
    bool copied(std::string_view name, const std::string& words, const std::string& full) const;

    /// Draws the picture of a choice as an item of that width.
    using PictureOf = std::function<void(std::size_t, float)>;
    /// A choice among names, labelled to the left, each beside its picture if there is one. @return the index chosen
    /// now, or `count`.
    std::size_t combo(std::string_view name, std::string_view shown, std::size_t count,
                      const std::function<std::string_view(std::size_t)>& nameOf,
                      const PictureOf& pictureOf = {}) const;
    /// @return whether it was clicked.
    bool button(std::string_view name) const;
    /// A button that shows whether what it stands for is on. @return whether it was clicked.
    bool toggle(std::string_view name, ToggleState state) const;
    bool checkbox(std::string_view name, bool& isOn) const;
    bool count(std::string_view name, int& value, int low, int high) const;
    /// @return whether it was moved.
    bool slider(std::string_view name, double& value, const SliderRange& range) const;
    /// A number that is typed. Each letter that makes another number changes it.
    bool number(std::string_view name, float& value) const;
    /// The next item goes beside the last.
    void beside() const;

  private:
    void label(std::string_view name) const;

    ItemPlaces& m_places;
};

/// A picture's colour as Dear ImGui packs it.
std::uint32_t packed(const image::Rgba8& color, std::uint8_t alpha = 255);

} // namespace cdr::viewer
