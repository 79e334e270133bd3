#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame_view.h>

#include <cstddef>

namespace cdr::render {

/// Sets viewport and scissor of the draws of one cascade.
void setCascadeViewport(vk::CommandBuffer commands, const FrameView& view, std::size_t cascade);

/// Binds a pipeline that draws a cascade, and then its push constants. Constants of a stage that the pipeline before did not
/// have are lost on lavapipe of Mesa 25.0, though the specification keeps them.
/// @param layout has shaders::CascadePush at offset 0, in both stages.
void bindForCascade(vk::CommandBuffer commands, vk::Pipeline pipeline, vk::PipelineLayout layout,
                    const shaders::CascadePush& constants);

} // namespace cdr::render
