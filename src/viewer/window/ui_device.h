#pragma once

#include "window.h"

#include <cdr/gpu/device.h>
#include <cdr/gpu/instance.h>

#include <memory>
#include <string>

namespace cdr::viewer {

/// A logical device of the interface's own that can present to a window. It shares nothing with the device
/// that renders, not even the instance. On a software driver an instance owns the threads that rasterise, and
/// a scene that takes a second would hold up the interface.
class UiDevice {
  public:
    struct Options {
        std::string choice;    ///< of a device, as gpu::Device takes it
        bool validate = false; ///< under the validation layers
    };
    /// @param options whose choice is as for gpu::Device; where that one cannot present, one that can is taken instead.
    /// base::RunError when none can.
    UiDevice(const WindowSystem& system, const Window& window, const Options& options);

    const gpu::Instance& instance() const { return m_instance; }
    const gpu::Device& device() const { return *m_device; }
    vk::SurfaceKHR surface() const { return *m_surface; }
    /// Makes the window's surface again, when nothing made from the old one is left. base::RunError when the
    /// device cannot present to it.
    void renewSurface(const Window& window);

  private:
    gpu::Instance m_instance;
    vk::UniqueSurfaceKHR m_surface;
    vk::UniqueDevice m_owned;
    std::unique_ptr<gpu::Device> m_device;
};

} // namespace cdr::viewer
