#include <cdr/base/format_error.h>
#include <cdr/gpu/functions.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <mutex>
#include <stdexcept>
#include <type_traits>

namespace cdr::gpu {

namespace {

// vulkan.hpp's calls take the functions from a place of the process; no other one can be given to them.
std::mutex functionsMutex;
Functions functionsOfProcess;

/// Stays open until the process ends, since objects of any lifetime call it.
PFN_vkGetInstanceProcAddr systemLoader() {
    try {
        static const vk::DynamicLoader kLibrary;
        return kLibrary.getProcAddress<PFN_vkGetInstanceProcAddr>("vkGetInstanceProcAddr");
    } catch (const std::runtime_error&) {
        throw base::RunError("no Vulkan loader found; install it, in Debian libvulkan1");
    }
}

/// Only what is not there yet is written, since other threads may be calling the rest.
template <typename Function>
void fillIn(Function& function, const char* name, VkInstance instance) {
    if (function == nullptr) {
        function = reinterpret_cast<Function>(functionsOfProcess.vkGetInstanceProcAddr(instance, name));
    }
}

/// The first function of Vulkan 1.3 that is not there; null where all are.
const char* firstMissing(const Functions& f) {
#define CDR_IF_MISSING(name)                                                                                 \
    if (f.name == nullptr) {                                                                                 \
        return #name;                                                                                        \
    }
    CDR_CORE_FUNCTIONS(CDR_IF_MISSING)
#undef CDR_IF_MISSING
    return nullptr;
}

template <typename Function>
constexpr bool kIsOfDevice = false;
template <typename First, typename... Rest>
constexpr bool kIsOfDevice<void(VKAPI_PTR*)(First, Rest...)> =
    std::is_same_v<First, VkDevice> || std::is_same_v<First, VkQueue> ||
    std::is_same_v<First, VkCommandBuffer>;
template <typename First, typename... Rest>
constexpr bool kIsOfDevice<VkResult(VKAPI_PTR*)(First, Rest...)> =
    kIsOfDevice<void(VKAPI_PTR*)(First, Rest...)>;

/// With the mutex held.
void loadGlobal(PFN_vkGetInstanceProcAddr loader) {
    Functions& f = functionsOfProcess;
    if (f.vkGetInstanceProcAddr == nullptr) {
        f.vkGetInstanceProcAddr = loader != nullptr ? loader : systemLoader();
    } else if (loader != nullptr && loader != f.vkGetInstanceProcAddr) {
        throw base::InputError(
            "the process already calls Vulkan by another loader; hand the host's in before the first use of cdr::gpu");
    }
#define CDR_FILL_IN(name) fillIn(f.name, #name, VK_NULL_HANDLE);
    CDR_GLOBAL_FUNCTIONS(CDR_FILL_IN)
#undef CDR_FILL_IN
}

} // namespace

const Functions& functions() {
    return functionsOfProcess;
}

void loadFunctions(PFN_vkGetInstanceProcAddr loader) {
    const std::lock_guard lock(functionsMutex);
    loadGlobal(loader);
}

void loadFunctions(PFN_vkGetInstanceProcAddr loader, VkInstance instance) {
    const std::lock_guard lock(functionsMutex);
    loadGlobal(loader);
    Functions& f = functionsOfProcess;
    const bool isFirst = f.vkDestroyInstance == nullptr;
#define CDR_FILL_IN(name) fillIn(f.name, #name, instance);
    CDR_CORE_FUNCTIONS(CDR_FILL_IN)
    CDR_WINDOW_FUNCTIONS(CDR_FILL_IN)
    CDR_EXTENSION_FUNCTIONS(CDR_FILL_IN)
#undef CDR_FILL_IN
    if (const char* missing = firstMissing(f)) {
        if (isFirst) {
            f = {}; // nothing was called yet, so another loader may be used
        }
        throw base::inputError("the Vulkan loader gives no {}; the instance must be made for Vulkan 1.3",
                               missing);
    }
}

void requireDeviceFunctions(VkDevice device) {
    // By an instance, a loader gives any function of a device that it knows itself.
#define CDR_REQUIRE(name)                                                                                    \
    if (kIsOfDevice<PFN_##name> && functionsOfProcess.vkGetDeviceProcAddr(device, #name) == nullptr) {       \
        throw base::InputError("the device gives no " #name "; its instance must be made for Vulkan 1.3");   \
    }
    CDR_CORE_FUNCTIONS(CDR_REQUIRE)
#undef CDR_REQUIRE
}

} // namespace cdr::gpu
