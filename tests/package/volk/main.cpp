// cdr draws for a program whose functions of Vulkan are volk's variables, by the loader that the program hands in.
// host.h calls what volk.h declares, so it follows.
// clang-format off
#define VOLK_IMPLEMENTATION
#include <volk.h>
#include "../host.h"
// clang-format on

#include <cdr/base/error.h>

#include <cstdio>

namespace {

int lookUps = 0;

/// The program's own loader: what a layer or a tool puts in between.
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL countedLookUp(VkInstance instance, const char* name) {
    ++lookUps;
    return vkGetInstanceProcAddr(instance, name);
}

} // namespace

int main() try {
    host::check(volkInitialize(), "volkInitialize");
    const VkInstance instance = host::makeInstance();
    volkLoadInstance(instance);
    const VkPhysicalDevice physical = host::firstDevice(instance);
    host::Features features;
    cdr::gpu::enableFeatures(instance, physical, features.all, countedLookUp);
    const VkDevice device = host::makeDevice(physical, features);
    volkLoadDevice(device);

    cdr::gpu::BorrowedDevice borrowed{.instance = instance,
                                      .physical = physical,
                                      .device = device,
                                      .loader = countedLookUp,
                                      .features = &features.all};
    vkGetDeviceQueue(device, 0, 0, &borrowed.queue);
    host::drawOneBox(cdr::gpu::Device(borrowed),
                     [] { std::printf("asked the program's loader: %s\n", lookUps > 0 ? "yes" : "no"); });

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
