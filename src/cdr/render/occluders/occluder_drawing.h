#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame_view.h>

#include <cstddef>

namespace cdr::render {

/// A frame as occluders are drawn for it. Cascades are cut and placed in the picture as in the frame itself, so occluders
/// cover the same pixels. But all are in one depth buffer of near / view distance, with the near plane of the camera.
FrameView occluderView(const FrameView& view);

/// The depth buffer that occluders are drawn into, and copied from.
gpu::ImageOptions occluderDepthOptions(vk::Extent2D extent);

/// Bytes of a copy of it.
std::size_t occluderCopyBytes(vk::Extent2D extent);

/// Begins a rendering scope that clears depth to what is infinitely far.
/// @param flags whether draws follow in secondaries or in line.
void beginOccluders(vk::CommandBuffer primary, const gpu::Image& depth, vk::RenderingFlags flags);

/// After the scope. Whoever reads the copy waits for it.
void copyOccluders(vk::CommandBuffer primary, const gpu::Image& depth, vk::Buffer copy);

} // namespace cdr::render
