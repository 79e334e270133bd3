#pragma once

#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/translucency/fragment_list.h>
#include <cdr/render/translucency/translucent_frame.h>

namespace cdr::render {

class UploadedScene;

/// Translucency::sorted: each instance is drawn once, whatever the cascades, or once for each slice of shadows. Its fragments go
/// into one list per pixel, which is sorted in place by metric view distance and blended once. The order is total, so the
/// picture has the same bits for every order of instances, thread count, targets, submission and number of cascades.
class SortedBlend {
  public:
    /// The device must have fragment stores. @param surroundings layout of TranslucentFrame::surroundings.
    SortedBlend(const gpu::Device& device, const UploadedScene& scene, const gpu::SetLayout& surroundings,
                const BlendOptions& options);

    /// Of FragmentList::set().
    const gpu::SetLayout& listLayout() const { return m_resolve.setLayout(); }

    /// Afterwards FragmentList::count() is the host's to read once the frame has finished. With too little
    /// room in the list the picture is incomplete.
    void record(vk::CommandBuffer primary, const TranslucentFrame& frame, const FragmentList& list) const;

  private:
    /// @param slice draws that alone; null: all.
    void recordDraws(vk::CommandBuffer primary, const TranslucentFrame& frame, const FragmentList& list,
                     const shaders::TranslucentSlice* slice) const;
    /// Lets a further slice follow one that was drawn.
    static void recordNext(vk::CommandBuffer primary, const TranslucentFrame& frame);

    const gpu::Device& m_device;
    FullscreenPass m_resolve; ///< its set is the list, which the pipelines fill
    TranslucentPipelines m_pipelines;
};

} // namespace cdr::render
