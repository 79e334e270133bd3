#pragma once

#include "input_event.h"

#include <cdr/gpu/vulkan_hpp.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace cdr::viewer {

/// GLFW, from first to last window. base::RunError, naming `fallback`, where there is no window system.
class WindowSystem {
  public:
    /// @param fallback a command that does without a window.
    explicit WindowSystem(const std::string& fallback);
    ~WindowSystem();
    WindowSystem(const WindowSystem&) = delete;
    WindowSystem& operator=(const WindowSystem&) = delete;

    /// Instance extensions that surfaces need.
    std::vector<const char*> instanceExtensions() const;
    /// Wakes Window::wait(); any thread may.
    static void wake();
};

/// Largest side a window may be asked for, in pixels.
inline constexpr int kMaxWindowSide = 16384;

/// What a window begins with.
struct FirstSize {
    std::uint32_t width = 0; ///< pixels, where the window system lets a program choose them
    std::uint32_t height = 0;
    bool isScaled = false; ///< to the display: so many pixels at 96 dots per inch
};

/// Where the pointer is and what it holds.
struct Pointer {
    double x = 0.0; ///< screen coordinates
    double y = 0.0;
    std::array<bool, 5> buttons{};
    std::array<bool, 5> pressed{}; ///< since Window::forgetPresses(), whether or not they are held still
};

/// A window and the input it received. Every input, injected or real, comes through the same callbacks.
class Window {
  public:
    Window(const WindowSystem&, const FirstSize& size, const std::string& title);
    Window(const Window&) = delete; // GLFW knows its address
    Window& operator=(const Window&) = delete;
    ~Window() = default;

    GLFWwindow* handle() const { return m_handle.get(); }
    vk::UniqueSurfaceKHR makeSurface(vk::Instance instance) const;

    /// Processes what has arrived; waits for it at most that long.
    void wait(double seconds) const;
    /// What happened since the last call, in order.
    std::vector<InputEvent> takeEvents() { return std::exchange(m_events, {}); }
    /// Calls the callbacks that GLFW would call.
    void inject(const InputEvent& event);

    bool isClosing() const;
    /// Pixels; 0x0 while minimised.
    vk::Extent2D extent() const { return m_extent; }
    /// Pixels per screen coordinate, 2 on a typical high density display that has its own coordinates.
    double pixelsPerUnit() const;
    /// How much larger text has to be than at 96 dots per inch, in screen coordinates.
    double textScale() const;
    const Pointer& pointer() const { return m_pointer; }
    /// Of Pointer::pressed.
    void forgetPresses() { m_pointer.pressed = {}; }

    /// Asks for a size in screen coordinates; what comes of it arrives as a ResizeInput.
    void resize(int width, int height) const;
    /// The picture area as the window system has it now.
    ResizeInput currentSize() const;
    void minimise() const;
    /// Removes it from the screen. It is not shown again.
    void hide() const;
    void restore() const;
    void copyToClipboard(const std::string& text) const;

  private:
    struct Destroy {
        void operator()(GLFWwindow* window) const;
    };
    struct Callbacks;

    std::unique_ptr<GLFWwindow, Destroy> m_handle;
    std::vector<InputEvent> m_events;
    Pointer m_pointer;
    vk::Extent2D m_extent;
};

} // namespace cdr::viewer
