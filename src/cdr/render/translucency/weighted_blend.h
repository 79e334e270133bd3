#pragma once

#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/translucency/translucent_frame.h>

#include <cstdint>

namespace cdr::render {

class UploadedScene;

/// Translucency::weighted: sums each cascade's fragments into two images, far cascade first, and lays the
/// weighted mean over what is farther. Additions on the device follow draw order. So the picture is the same
/// to the bit for every thread count, targets and submission, but not for another order of instances.
class WeightedBlend {
  public:
    /// @param surroundings layout of TranslucentFrame::surroundings.
    WeightedBlend(const gpu::Device& device, const UploadedScene& scene, const gpu::SetLayout& surroundings,
                  vk::Extent2D extent, const BlendOptions& options);

    void record(vk::CommandBuffer primary, const TranslucentFrame& frame) const;

    static std::uint64_t predictBytes(vk::Extent2D extent);

  private:
    /// What one rendering scope adds.
    struct Sum {
        std::size_t range = 0;
        const shaders::TranslucentSlice* slice = nullptr; ///< that alone; null: all
        bool isFirst = true;                              ///< of the range
    };
    void recordSums(vk::CommandBuffer primary, const TranslucentFrame& frame, std::size_t range) const;
    void recordSum(vk::CommandBuffer primary, const TranslucentFrame& frame, const Sum& sum) const;

    const gpu::Device& m_device;
    gpu::Image m_sum;    ///< weighted colours, and the transmittance
    gpu::Image m_weight; ///< the weights
    TranslucentPipelines m_pipelines;
    FullscreenPass m_resolve;
    PassInputs m_sums; ///< what it reads
};

} // namespace cdr::render
