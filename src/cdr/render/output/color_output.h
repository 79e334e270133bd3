#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/host_frame.h>

namespace cdr::render {

/// Brings a picture into a host's image of the same size, whose format says how it is encoded there, and leaves that in
/// the layout that it names.
/// @param picture in transfer source layout
void recordColorOutput(vk::CommandBuffer primary, const gpu::Image& picture, const SurfaceImage& into);

} // namespace cdr::render
