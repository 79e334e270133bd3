#pragma once

#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/targets/scope_secondary.h>

#include <memory>

namespace cdr::render {

/// Fills a G-buffer with background by a draw, in place of a clear. A software device clears pixels of 16 bytes
/// one by one, which takes three times as long.
class ZeroFill {
  public:
    ZeroFill(const gpu::Device& device, const TargetsOptions& options);

    /// Inside a rendering scope over all of the G-buffer and a depth buffer, before anything else: in line,
    void record(vk::CommandBuffer commands) const;
    /// or by this secondary.
    vk::CommandBuffer secondary() const { return m_secondary.commands(); }

  private:
    vk::Extent2D m_extent;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
    ScopeSecondary m_secondary;
};

/// One where the device is quicker with it, null elsewhere: there scopes clear.
std::unique_ptr<ZeroFill> makeZeroFill(const gpu::Device& device, const TargetsOptions& options);

} // namespace cdr::render
