#pragma once

#include <viewer/window/presenter.h>
#include <viewer/window/window.h>

#include <cstdint>

namespace cdr::viewer {

/// What arrow keys do.
enum class ArrowKeys : std::uint8_t {
    fly,    ///< they are not the interface's
    choose, ///< they go from item to item
};

/// Dear ImGui on a window: its context, fonts, style and back ends.
class Interface {
  public:
    Interface(const UiDevice& ui, Window& window, const Presenter& presenter, double scale);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// Starts a frame; widgets follow.
    /// @param seconds since the last.
    void begin(double seconds, ArrowKeys keys);
    /// Ends it; valid until the next begin().
    ImDrawData* end();

    /// Whether the pointer is over the interface or holds a part of it, so that the picture should not react.
    bool wantsPointer() const;
    /// Whether a text is being typed into the interface.
    bool wantsKeys() const;
    /// Whether a list is open or an item is held, which Escape ends first.
    bool wantsEscape() const;
    /// Screen coordinates per unit of 96 dots per inch.
    float scale() const { return m_scale; }

  private:
    /// Dear ImGui itself; ends its back ends too, as far as they were begun.
    struct Context {
        Context();
        ~Context();
        Context(const Context&) = delete;
        Context& operator=(const Context&) = delete;
    };
    void loadFont() const;
    void uploadFont() const;

    const gpu::Device& m_device;
    Window& m_window;
    float m_scale;
    vk::UniqueDescriptorPool m_descriptors;
    Context m_context;
};

} // namespace cdr::viewer
