#pragma once

#include <cdr/gpu/device.h>

#include <cstdint>
#include <string>

namespace cdr::cli {

/// base::InputError, with those there are, when --device names no device of this machine. An empty choice names all.
void requireKnownDevice(const std::string& choice);

/// Whether Vulkan's validation layers watch a command.
enum class Validation : std::uint8_t { off, on };

/// A Vulkan instance and device for one command.
class OpenedDevice {
  public:
    /// @param choice as gpu::Device takes it.
    OpenedDevice(const std::string& choice, Validation validation);

    const gpu::Device& device() const { return m_device; }
    /// "name, driver, Vulkan version": what a number was measured on.
    std::string text() const;

    /// base::RunError, with the first message, when the validation layers had anything to say.
    void requireSilentValidation() const;

  private:
    gpu::Instance m_instance;
    gpu::Device m_device;
};

} // namespace cdr::cli
