#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame_view.h>

#include <cstddef>

namespace cdr::render {

/// Sets viewport and scissor of the draws of one cascade.
void setCascadeViewport(vk::CommandBuffer commands, const FrameView& view, std::size_t cascade);

/// Sets viewport, scissor and push constants of the draws of one cascade.
/// @param layout has shaders::CascadePush at offset 0, in both stages.
void beginCascade(vk::CommandBuffer commands, const FrameView& view, std::size_t cascade,
                  vk::PipelineLayout layout);

} // namespace cdr::render
