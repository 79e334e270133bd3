#include <cdr/base/error.h>
#include <cdr/gpu/instance.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

namespace cdr::gpu {

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

bool hasLayer(const char* name) {
    const auto layers = vk::enumerateInstanceLayerProperties();
    return std::any_of(layers.begin(), layers.end(),
                       [&](const auto& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

bool hasExtension(const char* name) {
    const auto extensions = vk::enumerateInstanceExtensionProperties();
    return std::ranges::any_of(
        extensions, [&](const auto& extension) { return std::strcmp(extension.extensionName, name) == 0; });
}

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                         VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* log) {
    static_cast<ValidationLog*>(log)->add(data->pMessage ? data->pMessage : "(no text)");
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog& log) {
    return {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
            .pNext = nullptr,
            .flags = 0,
            .messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                               VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
            .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                           VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT,
            .pfnUserCallback = onMessage,
            .pUserData = &log};
}

} // namespace

void ValidationLog::add(std::string message) {
    const std::lock_guard lock(m_mutex);
    m_messages.push_back(std::move(message));
}

std::vector<std::string> ValidationLog::messages() const {
    const std::lock_guard lock(m_mutex);
    return m_messages;
}

std::size_t ValidationLog::count() const {
    const std::lock_guard lock(m_mutex);
    return m_messages.size();
}

struct Instance::Handles {
    struct MessengerDeleter {
        vk::Instance instance;
        void operator()(VkDebugUtilsMessengerEXT messenger) const;
    };
    using Messenger = std::unique_ptr<VkDebugUtilsMessengerEXT_T, MessengerDeleter>;

    vk::UniqueInstance instance;
    Messenger messenger;
};

Instance::~Instance() = default;
Instance::Instance(Instance&&) noexcept = default;

Instance& Instance::operator=(Instance&& other) noexcept {
    m_handles = std::move(other.m_handles); // first: the old ones may write to their log until they are gone
    m_hasDebugUtils = other.m_hasDebugUtils;
    m_validation = std::move(other.m_validation);
    return *this;
}

VkInstance Instance::handle() const {
    return *m_handles->instance;
}

void Instance::Handles::MessengerDeleter::operator()(VkDebugUtilsMessengerEXT messenger) const {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        instance.getProcAddr("vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance, messenger, nullptr);
}

Instance::Instance(const InstanceOptions& options)
    : m_validation(std::make_shared<ValidationLog>()),
      m_handles(std::make_unique<Handles>()) {
    loadFunctions(nullptr);
    if (functions().vkEnumerateInstanceVersion == nullptr ||
        vk::enumerateInstanceVersion() < VK_API_VERSION_1_3) {
        throw base::RunError("the Vulkan loader is older than 1.3; install a newer libvulkan1");
    }
    if (options.validate && !hasLayer(kValidationLayer)) {
        throw base::InputError(
            "--validate needs the Khronos validation layer; install vulkan-validationlayers");
    }
    for (const char* extension : options.extensions) {
        if (!hasExtension(extension)) {
            throw base::InputError(std::string("the Vulkan loader and its drivers lack ") + extension);
        }
    }
    std::vector<const char*> extensions = options.extensions;
    m_hasDebugUtils = hasExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (m_hasDebugUtils) {
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    }
    // Without it the loader hides drivers that lack a part of Vulkan, such as MoltenVK.
    const bool portable = hasExtension(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
    if (portable) {
        extensions.push_back(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
    }
    const vk::ApplicationInfo application{.pApplicationName = "cdr", .apiVersion = VK_API_VERSION_1_3};
    const auto messenger = messengerInfo(*m_validation);
    constexpr std::array kEnabled{vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
    const vk::ValidationFeaturesEXT features{.pNext = &messenger,
                                             .enabledValidationFeatureCount = kEnabled.size(),
                                             .pEnabledValidationFeatures = kEnabled.data()};
    try {
        m_handles->instance = vk::createInstanceUnique({
            .pNext = options.validate ? &features : nullptr,
            .flags =
                portable ? vk::InstanceCreateFlagBits::eEnumeratePortabilityKHR : vk::InstanceCreateFlags{},
            .pApplicationInfo = &application,
            .enabledLayerCount = options.validate ? 1u : 0u,
            .ppEnabledLayerNames = &kValidationLayer,
            .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
            .ppEnabledExtensionNames = extensions.data(),
        });
    } catch (const vk::IncompatibleDriverError&) {
        throw base::RunError(
            "no Vulkan driver found; install the graphics card's, or for a software one mesa-vulkan-drivers");
    }
    loadFunctions(nullptr, *m_handles->instance);
    if (options.validate && m_hasDebugUtils) {
        const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            m_handles->instance->getProcAddr("vkCreateDebugUtilsMessengerEXT"));
        VkDebugUtilsMessengerEXT handle = VK_NULL_HANDLE;
        const auto result =
            static_cast<vk::Result>(create(*m_handles->instance, &messenger, nullptr, &handle));
        vk::resultCheck(result, "vkCreateDebugUtilsMessengerEXT");
        m_handles->messenger = Handles::Messenger(handle, Handles::MessengerDeleter{*m_handles->instance});
    }
}

} // namespace cdr::gpu
