// What any engine has: images, pipelines and a queue. Nothing here is about cdr.
#pragma once

#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <span>

struct HostImage {
    vk::UniqueDeviceMemory memory;
    vk::UniqueImage image;
    vk::UniqueImageView view;
};

struct HostBuffer {
    vk::UniqueDeviceMemory memory;
    vk::UniqueBuffer buffer;
    void* mapped = nullptr;
};

struct HostPipelineOptions {
    std::span<const std::uint32_t> vertex;
    std::span<const std::uint32_t> fragment;
    vk::PipelineLayout layout;
    vk::Format colorFormat;
    vk::Format depthFormat;
    vk::CompareOp compare;
};

class Host {
  public:
    Host(vk::PhysicalDevice physical, vk::Device device, vk::Extent2D extent);

    HostImage makeImage(vk::Format format, vk::ImageUsageFlags usage, vk::ImageAspectFlags aspect) const;
    HostBuffer makeReadBuffer(vk::DeviceSize bytes) const;
    vk::UniquePipeline makePipeline(const HostPipelineOptions& options) const;
    vk::Device device() const { return m_device; }
    vk::Extent2D extent() const { return m_extent; }

  private:
    vk::UniqueDeviceMemory allocate(const vk::MemoryRequirements& needs,
                                    vk::MemoryPropertyFlags properties) const;

    vk::PhysicalDevice m_physical;
    vk::Device m_device;
    vk::Extent2D m_extent;
};
