// cdr draws on a device that an engine made by Vulkan's own functions, and the engine keeps it.
#include <cdr/base/error.h>
#include <cdr/gpu/features.h>
#include <cdr/render/renderer.h>

#include <vulkan/vulkan.h>

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace {

void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) {
        throw std::runtime_error(what);
    }
}

/// The first family that does graphics and compute.
std::uint32_t queueFamilyOf(VkPhysicalDevice physical) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    constexpr VkQueueFlags kBoth = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < count; ++i) {
        if ((families[i].queueFlags & kBoth) == kBoth) {
            return i;
        }
    }
    throw std::runtime_error("no queue for graphics and compute");
}

VkDevice makeDevice(VkPhysicalDevice physical, std::uint32_t family,
                    const VkPhysicalDeviceFeatures2& features) {
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = family;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    VkDevice device = VK_NULL_HANDLE;
    check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    return device;
}

void drawOneBox(const cdr::gpu::Device& device) {
    // quoted in README.md: begin
    cdr::scene::Scene scene; // or that of cdr::scene::openGltf("model.gltf")
    scene.meshes.push_back(cdr::scene::makeBox(glm::vec3(1.0f)));
    scene.materials.push_back({.name = "white"});
    cdr::scene::addInstance(scene, 0, 0, 41, {0.0, 0.0, -5.0}, glm::mat3(1.0f)); // object 41
    const cdr::render::GpuScene onDevice(device, scene);
    cdr::render::Renderer renderer(device, scene, onDevice,
                                   {.technique = cdr::depth::parseTechnique("anchored")});
    const cdr::render::Frame frame = renderer.render(cdr::scene::Camera{});
    const std::uint32_t id = frame.id(640, 360);          // object index + 1, 0 for the background
    const double distance = frame.distanceView(640, 360); // float64, in scene units, for every technique
    // quoted in README.md: end
    std::printf("id %u at %.6f\n", id, distance);
}

} // namespace

int main() try {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    VkInstance instance = VK_NULL_HANDLE;
    check(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");
    std::uint32_t count = 1;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    vkEnumeratePhysicalDevices(instance, &count, &physical); // the first will do
    const std::uint32_t family = queueFamilyOf(physical);

    // quoted in src/cdr/README.md: begin
    VkPhysicalDeviceVulkan13Features v13{};
    v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    VkPhysicalDeviceVulkan12Features v12{};
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v12.pNext = &v13;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &v12; // and what the engine itself needs
    cdr::gpu::enableFeatures(instance, physical, features);
    VkDevice device = makeDevice(physical, family, features);

    cdr::gpu::BorrowedDevice borrowed{.instance = instance,
                                      .physical = physical,
                                      .device = device,
                                      .queueFamily = family,
                                      .features = &features};
    vkGetDeviceQueue(device, family, 0, &borrowed.queue);
    drawOneBox(cdr::gpu::Device(borrowed));
    // quoted in src/cdr/README.md: end

    features.features.depthClamp = VK_FALSE; // had the engine left it off
    try {
        const cdr::gpu::Device refused(borrowed);
    } catch (const cdr::base::InputError& error) {
        std::printf("%s\n", error.what());
    }
    vkDestroyDevice(device, nullptr); // cdr destroyed only what it made itself
    vkDestroyInstance(instance, nullptr);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
