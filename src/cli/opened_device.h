#pragma once

#include <cdr/gpu/device.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace cdr::cli {

/// base::InputError, with those there are, when --device names no device of this machine. An empty choice names all.
void requireKnownDevice(const std::string& choice);

/// Whether Vulkan's validation layers watch a command.
enum class Validation : std::uint8_t { off, on };

/// A Vulkan instance. Once it is destroyed, it prints what the validation layers said that no error told.
class WatchedInstance {
  public:
    explicit WatchedInstance(Validation validation);
    ~WatchedInstance();
    WatchedInstance(const WatchedInstance&) = delete;
    WatchedInstance& operator=(const WatchedInstance&) = delete;

    const gpu::Instance& instance() const { return *m_instance; }
    /// base::RunError, with the first message, when the validation layers had anything to say.
    void requireSilentValidation() const;

  private:
    std::optional<gpu::Instance> m_instance;
    mutable std::size_t m_told = 0; ///< messages that an error told
};

/// A Vulkan instance and device for one command.
class OpenedDevice {
  public:
    /// @param choice as gpu::Device takes it.
    OpenedDevice(const std::string& choice, Validation validation);

    const gpu::Device& device() const { return m_device; }
    /// "name, driver, Vulkan version": what a number was measured on.
    std::string text() const;

    /// As WatchedInstance has it.
    void requireSilentValidation() const { m_instance.requireSilentValidation(); }

  private:
    WatchedInstance m_instance; // destroyed last, also where the device cannot be made
    gpu::Device m_device;
};

} // namespace cdr::cli
