#include "opened_device.h"

#include <cdr/base/format_error.h>
#include <cdr/gpu/device_query.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/platform/file.h>
#include <cdr/platform/standard_streams.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
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

namespace {

std::string summaryOf(const std::vector<std::string>& messages) {
    return fmt::format("{} validation messages, the first: {}", messages.size(), messages.front());
}

} // namespace

WatchedInstance::WatchedInstance(Validation validation) {
    m_instance.emplace(gpu::InstanceOptions{.validate = validation == Validation::on, .extensions = {}});
}

WatchedInstance::~WatchedInstance() {
    const auto log = m_instance->validationLog();
    m_instance.reset();
    std::vector<std::string> messages = log->messages();
    messages.erase(messages.begin(), messages.begin() + static_cast<std::ptrdiff_t>(m_told));
    if (!messages.empty()) {
        platform::printError("cdr: " + platform::withoutControls(summaryOf(messages)));
    }
}

void WatchedInstance::requireSilentValidation() const {
    const auto messages = m_instance->validation().messages();
    if (!messages.empty()) {
        m_told = messages.size();
        throw base::RunError(summaryOf(messages));
    }
}

OpenedDevice::OpenedDevice(const std::string& choice, Validation validation)
    : m_instance(validation),
      m_device(m_instance.instance(), choice) {
    gpu::keepPipelines(m_device);
}

std::string OpenedDevice::text() const {
    const gpu::DeviceInfo& info = m_device.info();
    return fmt::format("{}, {}, Vulkan {}", info.name, info.driver, info.api);
}

} // namespace cdr::cli
