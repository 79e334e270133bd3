#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/host_frame.h>

namespace cdr::render {

/// Copies a picture into a host's image of the same size. The format of that image says how colours are encoded there. The
/// image is left in the layout that `into` names.
/// @param picture in transfer source layout
void recordColorOutput(vk::CommandBuffer primary, const gpu::Image& picture, const SurfaceImage& into);

} // namespace cdr::render
