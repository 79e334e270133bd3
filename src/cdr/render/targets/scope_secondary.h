#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <functional>

namespace cdr::render {

struct TargetsOptions;

/// A secondary command buffer that is recorded once. Any rendering scope over the images of targets can execute
/// it. Frames in flight and the layers of one frame share it.
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
