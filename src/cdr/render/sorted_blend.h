#pragma once

#include <cdr/render/fragment_list.h>
#include <cdr/render/translucent_frame.h>

#include <vulkan/vulkan.hpp>

namespace cdr::render {

/// Translucency::sorted: all cascades put their fragments into one list per pixel, which is sorted in place
/// by metric view distance and blended once. The order is total, so the picture has the same bits for every
/// order of instances, thread count, targets, submission and number of cascades.
class SortedBlend {
  public:
    /// The device must have fragment stores. @param surroundings layout of TranslucentFrame::surroundings.
    SortedBlend(const gpu::Device& device, const GpuScene& scene, vk::DescriptorSetLayout surroundings,
                vk::Format litFormat, bool countsCoverage);

    vk::DescriptorSetLayout listLayout() const { return *m_listLayout; }

    /// Afterwards FragmentList::count() is the host's to read once the frame has finished. With too little
    /// room in the list the picture is incomplete.
    void record(vk::CommandBuffer primary, const TranslucentFrame& frame, const FragmentList& list) const;

  private:
    void recordDraws(vk::CommandBuffer primary, const TranslucentFrame& frame,
                     const FragmentList& list) const;
    void recordResolve(vk::CommandBuffer primary, const gpu::Image& lit, const FragmentList& list) const;

    const gpu::Device& m_device;
    vk::UniqueDescriptorSetLayout m_listLayout;
    TranslucentPipelines m_pipelines;
    vk::UniquePipelineLayout m_resolveLayout;
    vk::UniquePipeline m_resolve;
};

} // namespace cdr::render
