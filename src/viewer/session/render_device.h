#pragma once

#include <cdr/gpu/device.h>

#include <optional>
#include <string>
#include <utility>

namespace cdr::viewer {

/// The device that renders. It can be made again, so that the driver frees all that it kept.
class RenderDevice {
  public:
    /// @param choice for gpu::Device. The instance must outlive the device.
    RenderDevice(const gpu::Instance& instance, std::string choice)
        : m_instance(instance),
          m_choice(std::move(choice)) {
        renew();
    }

    const gpu::Device& device() const { return *m_device; }
    /// Nothing that was made on the device may be left.
    void renew() {
        m_device.reset();
        m_device.emplace(m_instance, m_choice);
    }

  private:
    const gpu::Instance& m_instance;
    std::string m_choice;
    std::optional<gpu::Device> m_device;
};

} // namespace cdr::viewer
