#include "opened_device.h"

#include <cdr/base/format_error.h>
#include <cdr/gpu/device_query.h>
#include <cdr/gpu/pipeline.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace cdr::cli {

void requireKnownDevice(const std::string& choice) {
    if (choice.empty()) {
        return;
    }
    std::vector<std::string> names;
    for (const gpu::DeviceInfo& info : gpu::listDevices(gpu::Instance({.extensions = {}}))) {
        if (gpu::isChosen(info, choice)) {
            return;
        }
        names.push_back(fmt::format("{} {}", info.index, info.name));
    }
    throw base::inputError("no Vulkan device matches '{}': there {} {}", choice.substr(0, 60),
                           names.size() == 1 ? "is" : "are",
                           names.empty() ? "none" : fmt::format("{}", fmt::join(names, "; ")));
}

OpenedDevice::OpenedDevice(const std::string& choice, Validation validation)
    : m_instance({.validate = validation == Validation::on, .extensions = {}}),
      m_device(m_instance, choice) {
    gpu::keepPipelines(m_device);
}

std::string OpenedDevice::text() const {
    const gpu::DeviceInfo& info = m_device.info();
    return fmt::format("{}, {}, Vulkan {}", info.name, info.driver, info.api);
}

void OpenedDevice::requireSilentValidation() const {
    const auto messages = m_instance.validation().messages();
    if (!messages.empty()) {
        throw base::runError("{} validation messages, the first: {}", messages.size(), messages.front());
    }
}

} // namespace cdr::cli
