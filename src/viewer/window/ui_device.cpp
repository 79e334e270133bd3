#include "ui_device.h"

#include <cdr/base/error.h>
#include <cdr/gpu/device_query.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::viewer {

namespace {

/// The queue family that draws and presents, if the device has such a one.
std::optional<std::uint32_t> presentingFamily(vk::PhysicalDevice physical, vk::SurfaceKHR surface) {
    const auto family = gpu::findQueueFamily(physical);
    const bool presents = family && gpu::hasExtension(physical, VK_KHR_SWAPCHAIN_EXTENSION_NAME) &&
                          physical.getSurfaceSupportKHR(*family, surface) &&
                          !physical.getSurfaceFormatsKHR(surface).empty();
    return presents ? family : std::nullopt;
}

vk::UniqueDevice makeDevice(vk::PhysicalDevice physical, std::uint32_t family) {
    constexpr float kPriority = 1.0f;
    const vk::DeviceQueueCreateInfo queue{
        .queueFamilyIndex = family, .queueCount = 1, .pQueuePriorities = &kPriority};
    const vk::PhysicalDeviceVulkan13Features features{.synchronization2 = true, .dynamicRendering = true};
    std::vector<const char*> extensions = gpu::extensionsAskedFor(physical);
    extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    return physical.createDeviceUnique(
        {.pNext = &features,
         .queueCreateInfoCount = 1,
         .pQueueCreateInfos = &queue,
         .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
         .ppEnabledExtensionNames = extensions.data()});
}

} // namespace

UiDevice::UiDevice(const WindowSystem& system, const Window& window, const Options& options)
    : m_instance({.validate = options.validate, .extensions = system.instanceExtensions()}),
      m_surface(window.makeSurface(m_instance.handle())) {
    const auto devices = vk::Instance(m_instance.handle()).enumeratePhysicalDevices();
    // The one that renders first; the choice itself is checked by whoever makes that device.
    std::vector<std::uint32_t> order;
    try {
        order.push_back(gpu::Device(m_instance, options.choice).info().index);
    } catch (const base::InputError&) {
    }
    for (std::uint32_t index = 0; index < devices.size(); ++index) {
        order.push_back(index);
    }
    for (const std::uint32_t index : order) {
        const auto family = presentingFamily(devices[index], *m_surface);
        if (!family || !gpu::describe(devices[index], index).missing.empty()) {
            continue;
        }
        m_owned = makeDevice(devices[index], *family);
        m_device =
            std::make_unique<gpu::Device>(gpu::BorrowedDevice{.instance = m_instance.handle(),
                                                              .physical = devices[index],
                                                              .device = *m_owned,
                                                              .queue = m_owned->getQueue(*family, 0),
                                                              .queueFamily = *family,
                                                              .hasDebugNames = m_instance.hasDebugNames()});
        return;
    }
    throw base::RunError("no device that cdr can use presents to this window system");
}

void UiDevice::renewSurface(const Window& window) {
    m_surface.reset(); // a window has one at a time
    m_surface = window.makeSurface(m_instance.handle());
    if (!presentingFamily(m_device->physical(), *m_surface)) {
        throw base::RunError("the window's surface was lost, and the device cannot present to a new one");
    }
}

} // namespace cdr::viewer
