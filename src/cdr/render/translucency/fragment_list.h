#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/translucency/translucency.h>

#include <cstdint>
#include <optional>

namespace cdr::render {

/// One frame slot's lists of translucent fragments on the device (shaders/translucency/fragment_list.glsl). Grows to what
/// a frame asked for, up to a bound.
class FragmentList {
  public:
    /// Why there can be no lists at all for a picture; none if there can.
    /// @param otherBuffers storage buffers that draws read beside the lists
    static std::optional<ListRefusal> refusal(const gpu::Device& device, vk::Extent2D extent,
                                              std::uint64_t maxBytes, std::uint32_t otherBuffers);

    /// Has no room before begin(). There must be no refusal().
    FragmentList(const gpu::Device& device, const gpu::SetLayout& layout, vk::Extent2D extent,
                 std::uint64_t maxBytes);

    vk::DescriptorSet set() const { return *m_set; }
    /// Fragments; 0 before begin(), and after grow() threw.
    std::uint32_t capacity() const { return m_capacity; }
    std::uint64_t bytes() const { return m_heads.size() + m_nodes.size(); }

    /// Empties the lists and sets their counter to 0; outside a rendering scope.
    void recordClear(vk::CommandBuffer primary) const;
    /// Copies the counter to where count() reads it; behind a barrier from the last draw to transfers.
    void recordCount(vk::CommandBuffer primary) const;
    /// Fragments that the last frame had, room or not; shaders::kMostCounted where it had as many or more. The frame must have
    /// finished.
    std::uint32_t count() const;

    /// Where there is no room, makes it for a fragment per pixel, or for as many as the bound allows; as grow().
    std::optional<ListRefusal> begin();
    /// Makes room for `fragments`, which it must not have yet; no frame may be using the lists. Else says why
    /// there can be none. base::RunError where the device's memory went meanwhile; then begin() is to be called before it is used.
    std::optional<ListRefusal> grow(std::uint64_t fragments);

    /// Descriptors in a set: heads, nodes, count.
    static constexpr std::uint32_t kBindings = 3;

  private:
    std::uint64_t mostFragments() const;
    /// @param spare fragments more, where there is room for them
    std::optional<ListRefusal> makeRoom(std::uint64_t fragments, std::uint64_t spare);
    void makeNodes(std::uint64_t fragments);

    const gpu::Device& m_device;
    std::uint64_t m_maxBytes;
    gpu::Buffer m_heads;
    gpu::Buffer m_nodes;
    gpu::Buffer m_count;     ///< every fragment adds to it, so it stays on the device
    gpu::Buffer m_readCount; ///< a copy
    std::uint32_t m_capacity = 0;
    gpu::DescriptorSet m_set;
};

} // namespace cdr::render
