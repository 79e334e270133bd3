// What any Vulkan engine has: images with memory, and a pipeline.
#pragma once

#include <cdr/gpu/device.h>

#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <vulkan/vulkan.hpp>

struct HostImage {
    vk::UniqueDeviceMemory memory;
    vk::UniqueImage image;
    vk::UniqueImageView view;
};

vk::UniqueDeviceMemory allocate(const cdr::gpu::Device& device, const vk::MemoryRequirements& needs,
                                vk::MemoryPropertyFlags wanted);

HostImage makeImage(const cdr::gpu::Device& device, vk::Extent2D extent, vk::Format format,
                    vk::ImageUsageFlags usage, vk::ImageAspectFlags aspect);

/// Draws into a G-buffer and the depth of a cascade.
vk::UniquePipeline makePipeline(vk::Device device, vk::PipelineLayout layout);
