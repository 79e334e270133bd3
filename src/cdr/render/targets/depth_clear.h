#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/targets/scope_secondary.h>

namespace cdr::render {

/// Clears the depth buffer inside a rendering scope, so that a nearer cascade is drawn over a farther one without leaving
/// the scope. A graphics card that draws by tiles then keeps the G-buffer on the chip.
class DepthClear {
  public:
    DepthClear(const gpu::Device& device, const TargetsOptions& options);

    /// In line,
    void record(vk::CommandBuffer commands) const;
    /// or by this secondary.
    vk::CommandBuffer secondary() const { return m_secondary.commands(); }

  private:
    vk::Extent2D m_extent;
    float m_zNdc; ///< what nothing is farther than
    ScopeSecondary m_secondary;
};

} // namespace cdr::render
