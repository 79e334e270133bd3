#include "session.h"

#include <cdr/base/error.h>

#include <fmt/format.h>

namespace cdr::cli {

Session::Session(const GlobalOptions& options)
    : m_instance({.validate = options.validate, .extensions = {}}),
      m_device(m_instance, options.device) {}

host::DocumentDevice Session::documentDevice() const {
    const gpu::DeviceInfo& info = m_device.info();
    return {.name = info.name, .driver = info.driver, .api = info.api};
}

void Session::requireSilentValidation() const {
    const auto messages = m_instance.validation().messages();
    if (!messages.empty()) {
        throw base::RunError(
            fmt::format("{} validation messages, the first: {}", messages.size(), messages.front()));
    }
}

std::string describe(const gpu::Device& device) {
    return fmt::format("{}, {}, Vulkan {}", device.info().name, device.info().driver, device.info().api);
}

} // namespace cdr::cli
