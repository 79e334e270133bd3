// cdr draws for a program whose functions of Vulkan are volk's variables, by the loader that the program hands in.
#define VOLK_IMPLEMENTATION
#include <cdr/base/error.h>
#include <cdr/gpu/features.h>
#include <cdr/render/renderer.h>

#include <volk.h>

#include <cstdint>
#include <cstdio>
#include <stdexcept>

namespace {

int lookUps = 0;

/// The program's own loader: what a layer or a tool puts in between.
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL countedLookUp(VkInstance instance, const char* name) {
    ++lookUps;
    return vkGetInstanceProcAddr(instance, name);
}

void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) {
        throw std::runtime_error(what);
    }
}

VkInstance makeInstance() {
    check(volkInitialize(), "volkInitialize");
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    VkInstance instance = VK_NULL_HANDLE;
    check(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");
    volkLoadInstance(instance);
    return instance;
}

VkDevice makeDevice(VkPhysicalDevice physical, const VkPhysicalDeviceFeatures2& features) {
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1; // of family 0, which does graphics and compute on the devices that this is run on
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    VkDevice device = VK_NULL_HANDLE;
    check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    volkLoadDevice(device);
    return device;
}

void drawOneBox(const cdr::gpu::Device& device) {
    cdr::scene::Scene scene;
    scene.meshes.push_back(cdr::scene::makeBox(glm::vec3(1.0f)));
    scene.materials.push_back({.name = "white"});
    cdr::scene::addInstance(scene, 0, 0, 41, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
    const cdr::render::GpuScene onDevice(device, scene);
    cdr::render::Renderer renderer(
        device, scene, onDevice,
        {.width = 64, .height = 64, .technique = cdr::depth::parseTechnique("anchored")});
    const cdr::render::Frame frame = renderer.render(cdr::scene::Camera{});
    std::printf("id %u at %.6f\n", frame.id(32, 32), frame.distanceView(32, 32));
}

} // namespace

int main() try {
    const VkInstance instance = makeInstance();
    std::uint32_t count = 1;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    vkEnumeratePhysicalDevices(instance, &count, &physical); // the first will do
    VkPhysicalDeviceVulkan13Features v13{};
    v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    VkPhysicalDeviceVulkan12Features v12{};
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v12.pNext = &v13;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &v12;
    cdr::gpu::enableFeatures(instance, physical, features, countedLookUp);
    const VkDevice device = makeDevice(physical, features);

    cdr::gpu::BorrowedDevice borrowed{.instance = instance,
                                      .physical = physical,
                                      .device = device,
                                      .loader = countedLookUp,
                                      .features = &features};
    vkGetDeviceQueue(device, 0, 0, &borrowed.queue);
    drawOneBox(cdr::gpu::Device(borrowed));
    std::printf("asked the program's loader: %s\n", lookUps > 0 ? "yes" : "no");

    borrowed.loader = vkGetInstanceProcAddr; // another one, half-way
    try {
        const cdr::gpu::Device refused(borrowed);
    } catch (const cdr::base::InputError& error) {
        std::printf("%s\n", error.what());
    }
    vkDestroyDevice(device, nullptr);
    vkDestroyInstance(instance, nullptr);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
