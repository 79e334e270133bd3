#include <cdr/render/geometry/begin_cascade.h>
#include <cdr/render/geometry/geometry_pipelines.h>

namespace cdr::render {

void setCascadeViewport(vk::CommandBuffer commands, const FrameView& view, std::size_t cascade) {
    const auto& [width, height] = view.cascades[cascade].extent;
    const DepthSlice& slice = view.cascades[cascade].slice;
    commands.setViewport(0, vk::Viewport{0.0f, 0.0f, static_cast<float>(width), static_cast<float>(height),
                                         slice.min, slice.max});
    commands.setScissor(0, vk::Rect2D{{0, 0}, {width, height}});
}

void bindForCascade(vk::CommandBuffer commands, vk::Pipeline pipeline, vk::PipelineLayout layout,
                    const shaders::CascadePush& constants) {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline);
    commands.pushConstants<shaders::CascadePush>(layout, GeometryPipelines::kStages, 0, constants);
}

} // namespace cdr::render
