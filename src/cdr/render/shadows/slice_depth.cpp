#include <cdr/gpu/commands.h>
#include <cdr/render/shadows/slice_depth.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer.h>
#include <cdr/shaders/shading.h>
#include <cdr/shaders/shadows.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace cdr::render {

namespace {

gpu::ImageOptions sliceOptions(vk::Extent2D extent) {
    return {.extent = extent,
            .format = SliceDepth::kFormat,
            .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
            .aspect = vk::ImageAspectFlagBits::eDepth};
}

vk::ImageMemoryBarrier2 sliceBarrier(const gpu::Image& depth, vk::AccessFlags2 before, vk::AccessFlags2 after,
                                     vk::ImageLayout layoutBefore) {
    return gpu::imageBarrier(depth.handle(), vk::ImageAspectFlagBits::eDepth,
                             {kDepthStages, before, layoutBefore},
                             {kDepthStages, after, vk::ImageLayout::eAttachmentOptimal});
}

} // namespace

SliceDepth::SliceDepth(const gpu::Device& device, const gpu::Image& gbuffer,
                       const std::vector<vk::DescriptorType>& bindings, depth::Mapping mapping)
    : m_passes(ByCascades<FullscreenPass>::make(
          depth::isAnchored(mapping),
          [&](AnchorForm anchors) {
              return FullscreenPass(
                  device,
                  {.name = "shadow slices",
                   .vertexSpirv = kFlatAnchorsVert,
                   .fragmentSpirv = isVisibilityBuffer(gbuffer) ? gpu::Spirv(kSliceFacetsFrag) : kSliceFrag,
                   .bindings = bindings,
                   .constants = {static_cast<std::uint32_t>(anchors)},
                   .pushBytes = sizeof(shaders::SlicePush),
                   .writtenDepth = kFormat});
          })),
      m_depth(device, sliceOptions(gbuffer.options().extent), "shadow slices") {}

void SliceDepth::record(vk::CommandBuffer primary, vk::DescriptorSet set, const shaders::SlicePush& push,
                        std::size_t cascades) const {
    gpu::pipelineBarrier(primary,
                         {sliceBarrier(m_depth, Access::eDepthStencilAttachmentRead,
                                       Access::eDepthStencilAttachmentWrite, vk::ImageLayout::eUndefined)});
    m_passes.of(cascades).recordDepth(primary, {.set = set, .push = std::as_bytes(std::span(&push, 1))},
                                      m_depth.view(), m_depth.options().extent);
    gpu::pipelineBarrier(
        primary, {sliceBarrier(m_depth, Access::eDepthStencilAttachmentWrite,
                               Access::eDepthStencilAttachmentRead, vk::ImageLayout::eAttachmentOptimal)});
}

std::uint64_t SliceDepth::predictBytes(const gpu::Device& device, vk::Extent2D extent) {
    return gpu::predictBytes(device, sliceOptions(extent));
}

shaders::SlicePush slicePush(std::span<const ReceiverSlice> slices, ShadowMethod method) {
    const bool isPlain = method == ShadowMethod::plain;
    shaders::SlicePush push{.nearView = shaders::vec4(std::numeric_limits<float>::infinity()),
                            .isPlain = isPlain ? 1u : 0u};
    for (std::size_t i = 0; isPlain && i < slices.size(); ++i) {
        push.nearView[static_cast<glm::length_t>(i)] = static_cast<float>(slices[i].nearView);
    }
    return push;
}

float sliceDepth(std::span<const ReceiverSlice> slices, std::size_t slice, ShadowMethod method) {
    constexpr int kExponentBias = 127;
    const int number = method == ShadowMethod::plain ? static_cast<int>(slice) + 1
                                                     : std::ilogb(slices[slice].nearView) + kExponentBias;
    return static_cast<float>(number) / shaders::kMaxSlices;
}

} // namespace cdr::render
