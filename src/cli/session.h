#pragma once

#include <cdr/gpu/device.h>
#include <cdr/host/document.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace cdr::cli {

/// Options that stand before the command.
struct GlobalOptions {
    std::string device; ///< index or part of a name; empty for the best
    bool validate = false;
    bool quiet = false;
    std::string section; ///< of a report that the command runs for: only its progress shows, under this name
};

/// What every command takes.
struct OutputOptions {
    std::optional<std::filesystem::path> json; ///< "-" is standard output
};

/// A Vulkan instance and device for one command.
class Session {
  public:
    explicit Session(const GlobalOptions& options);

    const gpu::Device& device() const { return m_device; }
    const gpu::Instance& instance() const { return m_instance; }
    host::DocumentDevice documentDevice() const;

    /// base::RunError, with the first message, when the validation layers had anything to say.
    void requireSilentValidation() const;

  private:
    gpu::Instance m_instance;
    gpu::Device m_device;
};

/// "name, driver": what a number was measured on.
std::string describe(const gpu::Device& device);

} // namespace cdr::cli
