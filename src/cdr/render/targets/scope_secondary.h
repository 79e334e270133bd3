#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <functional>

namespace cdr::render {

struct TargetsOptions;

/// A secondary command buffer that is recorded once and executed in any rendering scope over the images of targets, by
/// frames in flight and by the layers of one frame alike.
class ScopeSecondary {
  public:
    ScopeSecondary(const gpu::Device& device, const TargetsOptions& options,
                   const std::function<void(vk::CommandBuffer)>& record);

    vk::CommandBuffer commands() const { return *m_commands; }

  private:
    vk::UniqueCommandPool m_pool;
    vk::UniqueCommandBuffer m_commands;
};

} // namespace cdr::render
