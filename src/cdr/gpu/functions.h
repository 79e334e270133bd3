#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>

// The lists are macros, since each name becomes a type, a member and a text.

/// Functions that need no instance.
#define CDR_GLOBAL_FUNCTIONS(X)                                                                              \
    X(vkCreateInstance)                                                                                      \
    X(vkEnumerateInstanceExtensionProperties)                                                                \
    X(vkEnumerateInstanceLayerProperties)                                                                    \
    X(vkEnumerateInstanceVersion)

/// Functions of Vulkan 1.3 that need an instance or a device.
#define CDR_CORE_FUNCTIONS(X)                                                                                \
    X(vkAllocateCommandBuffers)                                                                              \
    X(vkAllocateDescriptorSets)                                                                              \
    X(vkBeginCommandBuffer)                                                                                  \
    X(vkCmdBeginQuery)                                                                                       \
    X(vkCmdBeginRenderPass)                                                                                  \
    X(vkCmdBeginRendering)                                                                                   \
    X(vkCmdBindDescriptorSets)                                                                               \
    X(vkCmdBindIndexBuffer)                                                                                  \
    X(vkCmdBindPipeline)                                                                                     \
    X(vkCmdBindVertexBuffers)                                                                                \
    X(vkCmdBlitImage)                                                                                        \
    X(vkCmdClearAttachments)                                                                                 \
    X(vkCmdClearColorImage)                                                                                  \
    X(vkCmdCopyBuffer)                                                                                       \
    X(vkCmdCopyBufferToImage)                                                                                \
    X(vkCmdCopyImage)                                                                                        \
    X(vkCmdCopyImageToBuffer)                                                                                \
    X(vkCmdCopyQueryPoolResults)                                                                             \
    X(vkCmdDispatch)                                                                                         \
    X(vkCmdDraw)                                                                                             \
    X(vkCmdDrawIndexed)                                                                                      \
    X(vkCmdDrawIndexedIndirectCount)                                                                         \
    X(vkCmdEndQuery)                                                                                         \
    X(vkCmdEndRenderPass)                                                                                    \
    X(vkCmdEndRendering)                                                                                     \
    X(vkCmdExecuteCommands)                                                                                  \
    X(vkCmdFillBuffer)                                                                                       \
    X(vkCmdPipelineBarrier2)                                                                                 \
    X(vkCmdPushConstants)                                                                                    \
    X(vkCmdResetQueryPool)                                                                                   \
    X(vkCmdSetCullMode)                                                                                      \
    X(vkCmdSetDepthBias)                                                                                     \
    X(vkCmdSetFrontFace)                                                                                     \
    X(vkCmdSetScissor)                                                                                       \
    X(vkCmdSetViewport)                                                                                      \
    X(vkCmdWriteTimestamp2)                                                                                  \
    X(vkCreateBuffer)                                                                                        \
    X(vkCreateBufferView)                                                                                    \
    X(vkCreateCommandPool)                                                                                   \
    X(vkCreateComputePipelines)                                                                              \
    X(vkCreateDescriptorPool)                                                                                \
    X(vkCreateDescriptorSetLayout)                                                                           \
    X(vkCreateDevice)                                                                                        \
    X(vkCreateFence)                                                                                         \
    X(vkCreateFramebuffer)                                                                                   \
    X(vkCreateGraphicsPipelines)                                                                             \
    X(vkCreateImage)                                                                                         \
    X(vkCreateImageView)                                                                                     \
    X(vkCreatePipelineCache)                                                                                 \
    X(vkCreatePipelineLayout)                                                                                \
    X(vkCreateQueryPool)                                                                                     \
    X(vkCreateRenderPass)                                                                                    \
    X(vkCreateSampler)                                                                                       \
    X(vkCreateSemaphore)                                                                                     \
    X(vkCreateShaderModule)                                                                                  \
    X(vkDestroyBuffer)                                                                                       \
    X(vkDestroyBufferView)                                                                                   \
    X(vkDestroyCommandPool)                                                                                  \
    X(vkDestroyDescriptorPool)                                                                               \
    X(vkDestroyDescriptorSetLayout)                                                                          \
    X(vkDestroyDevice)                                                                                       \
    X(vkDestroyFence)                                                                                        \
    X(vkDestroyFramebuffer)                                                                                  \
    X(vkDestroyImage)                                                                                        \
    X(vkDestroyImageView)                                                                                    \
    X(vkDestroyInstance)                                                                                     \
    X(vkDestroyPipeline)                                                                                     \
    X(vkDestroyPipelineCache)                                                                                \
    X(vkDestroyPipelineLayout)                                                                               \
    X(vkDestroyQueryPool)                                                                                    \
    X(vkDestroyRenderPass)                                                                                   \
    X(vkDestroySampler)                                                                                      \
    X(vkDestroySemaphore)                                                                                    \
    X(vkDestroyShaderModule)                                                                                 \
    X(vkDeviceWaitIdle)                                                                                      \
    X(vkEndCommandBuffer)                                                                                    \
    X(vkEnumerateDeviceExtensionProperties)                                                                  \
    X(vkEnumeratePhysicalDevices)                                                                            \
    X(vkFreeCommandBuffers)                                                                                  \
    X(vkGetDeviceImageMemoryRequirements)                                                                    \
    X(vkGetDeviceProcAddr)                                                                                   \
    X(vkGetDeviceQueue)                                                                                      \
    X(vkGetFenceStatus)                                                                                      \
    X(vkGetPhysicalDeviceFeatures)                                                                           \
    X(vkGetPhysicalDeviceFeatures2)                                                                          \
    X(vkGetPhysicalDeviceFormatProperties)                                                                   \
    X(vkGetPhysicalDeviceMemoryProperties)                                                                   \
    X(vkGetPhysicalDeviceProperties)                                                                         \
    X(vkGetPhysicalDeviceProperties2)                                                                        \
    X(vkGetPhysicalDeviceQueueFamilyProperties)                                                              \
    X(vkGetQueryPoolResults)                                                                                 \
    X(vkGetSemaphoreCounterValue)                                                                            \
    X(vkQueueSubmit2)                                                                                        \
    X(vkQueueWaitIdle)                                                                                       \
    X(vkResetCommandPool)                                                                                    \
    X(vkResetFences)                                                                                         \
    X(vkUpdateDescriptorSets)                                                                                \
    X(vkWaitForFences)                                                                                       \
    X(vkWaitSemaphores)

/// Functions that are there where an instance has the extensions of a window system.
#define CDR_WINDOW_FUNCTIONS(X)                                                                              \
    X(vkAcquireNextImageKHR)                                                                                 \
    X(vkCreateSwapchainKHR)                                                                                  \
    X(vkDestroySurfaceKHR)                                                                                   \
    X(vkDestroySwapchainKHR)                                                                                 \
    X(vkGetPhysicalDeviceSurfaceCapabilitiesKHR)                                                             \
    X(vkGetPhysicalDeviceSurfaceFormatsKHR)                                                                  \
    X(vkGetPhysicalDeviceSurfacePresentModesKHR)                                                             \
    X(vkGetPhysicalDeviceSurfaceSupportKHR)                                                                  \
    X(vkGetSwapchainImagesKHR)                                                                               \
    X(vkQueuePresentKHR)

/// Functions of extensions that cdr uses where a device has them. A loader that does not know one leaves it null.
#define CDR_EXTENSION_FUNCTIONS(X)                                                                           \
    X(vkCmdBeginConditionalRenderingEXT)                                                                     \
    X(vkCmdEndConditionalRenderingEXT)

namespace cdr::gpu {

/// The functions of Vulkan that cdr calls. vulkan.hpp calls by it (vulkan_hpp.h). So nothing here links the system's loader,
/// and no function of a host that has the same name is called by mistake.
struct Functions {
    PFN_vkGetInstanceProcAddr vkGetInstanceProcAddr = nullptr; ///< the loader that the rest came from
#define CDR_MEMBER(name) PFN_##name name = nullptr;
    CDR_GLOBAL_FUNCTIONS(CDR_MEMBER)
    CDR_CORE_FUNCTIONS(CDR_MEMBER)
    CDR_WINDOW_FUNCTIONS(CDR_MEMBER)
    CDR_EXTENSION_FUNCTIONS(CDR_MEMBER)
#undef CDR_MEMBER

    /// What vulkan.hpp compares its own version with in debug builds.
    std::size_t getVkHeaderVersion() const {
        return VK_HEADER_VERSION;
    }
};

/// The functions of this process. Those that no loadFunctions() filled in are null.
const Functions& functions();

/// Fills in the functions that need no instance. Does nothing where they are there. From any thread.
/// @param loader a host's vkGetInstanceProcAddr. Null: the one in use. Where there is none, the system's loader is opened.
/// base::RunError when the system has no loader. base::InputError for another loader than the one in use: a process has one.
void loadFunctions(PFN_vkGetInstanceProcAddr loader);

/// The same, and then the functions of an instance. Those of a window system stay null where it lacks the extensions.
/// base::InputError that names a function of Vulkan 1.3 which the loader does not know for this instance.
void loadFunctions(PFN_vkGetInstanceProcAddr loader, VkInstance instance);

/// base::InputError that names a function of Vulkan 1.3 which this device does not have, since its instance was made for an
/// earlier version. Call loadFunctions() first.
void requireDeviceFunctions(VkDevice device);

} // namespace cdr::gpu
