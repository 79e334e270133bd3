#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <functional>
#include <memory>

namespace cdr::render {

struct TargetsOptions;

/// Commands that any rendering scope over the images of targets can take in. Where it takes secondaries, frames in flight
/// and the layers of one frame share one that is recorded once.
class ScopeCommands {
  public:
    using Record = std::function<void(vk::CommandBuffer)>;

    ScopeCommands(const gpu::Device& device, const TargetsOptions& options, Record record);

    /// @param commands inside a scope that began with these flags.
    void putInto(vk::CommandBuffer commands, vk::RenderingFlags flags) const;

  private:
    Record m_record; ///< holds what m_secondary uses
    vk::UniqueCommandPool m_pool;
    vk::UniqueCommandBuffer m_secondary;
};

/// Clears the depth buffer, so that a nearer cascade is drawn over a farther one without leaving the scope. A graphics
/// card that draws by tiles then keeps the G-buffer on the chip.
ScopeCommands makeDepthClear(const gpu::Device& device, const TargetsOptions& options);

/// Fills the G-buffer with background by a draw, in place of a clear and before anything else. A software device clears
/// pixels of 16 bytes one by one, which takes three times as long. Null where the device clears quickly.
std::unique_ptr<ScopeCommands> makeZeroFill(const gpu::Device& device, const TargetsOptions& options);

} // namespace cdr::render
