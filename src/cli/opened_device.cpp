#include "opened_device.h"

#include <cdr/base/error.h>

#include <fmt/format.h>

namespace cdr::cli {

OpenedDevice::OpenedDevice(const std::string& choice, bool validate)
    : m_instance({.validate = validate, .extensions = {}}),
      m_device(m_instance, choice) {}

host::DocumentDevice OpenedDevice::documentDevice() const {
    const gpu::DeviceInfo& info = m_device.info();
    return {.name = info.name, .driver = info.driver, .api = info.api};
}

std::string OpenedDevice::text() const {
    const gpu::DeviceInfo& info = m_device.info();
    return fmt::format("{}, {}, Vulkan {}", info.name, info.driver, info.api);
}

void OpenedDevice::requireSilentValidation() const {
    const auto messages = m_instance.validation().messages();
    if (!messages.empty()) {
        throw base::RunError(
            fmt::format("{} validation messages, the first: {}", messages.size(), messages.front()));
    }
}

} // namespace cdr::cli
