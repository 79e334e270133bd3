#include <cdr/render/frame/frame_output.h>
#include <cdr/render/output/color_output.h>

#include <memory>

namespace cdr::render {

namespace {

SurfaceImage surfaceOf(const gpu::Image& image) {
    return {.image = image.handle(),
            .view = image.view(),
            .format = static_cast<VkFormat>(image.options().format),
            .extent = image.options().extent,
            .layout = VK_IMAGE_LAYOUT_UNDEFINED};
}

/// As Picture::finish(), the passes that read the G-buffer and copies to main memory leave them.
void setLayouts(Surfaces& surfaces, std::optional<FrameCopy> copy) {
    surfaces.color.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    if (surfaces.gbuffer.image != VK_NULL_HANDLE) {
        surfaces.gbuffer.layout = copy == FrameCopy::everything ? VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL
                                                                : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    }
    if (surfaces.linear.image != VK_NULL_HANDLE) {
        surfaces.linear.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    }
    if (surfaces.motion.image != VK_NULL_HANDLE) {
        surfaces.motion.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    }
}

} // namespace

Surfaces surfacesOf(const FramePasses& passes, const FrameSlot* last) {
    Surfaces surfaces{.color = surfaceOf(passes.picture.encoded()), .gbuffer = {}, .anchorsView = {}};
    if (passes.resolve == nullptr) {
        surfaces.gbuffer = surfaceOf(passes.targets.gbuffer());
    }
    if (passes.picture.linear() != nullptr) {
        surfaces.linear = surfaceOf(*passes.picture.linear());
    }
    if (passes.motion != nullptr) {
        surfaces.motion = surfaceOf(passes.motion->image());
    }
    if (last != nullptr) {
        setLayouts(surfaces, last->copy);
        surfaces.anchorsView = last->view.anchorsView();
    }
    return surfaces;
}

void recordOutputs(const gpu::Device& device, FramePasses& passes, FrameSlot& slot, const HostFrame& host) {
    const vk::CommandBuffer primary = slot.path->primary();
    if (host.depth) {
        if (passes.depthOutput == nullptr) {
            passes.depthOutput = std::make_unique<DepthOutput>(device);
        }
        if (!slot.inputs->depthOutput) {
            slot.inputs->depthOutput = passes.depthOutput->makeInputs(passes.gbuffer(), slot.inputs->shading);
        }
        passes.depthOutput->record(primary, *slot.inputs->depthOutput, *host.depth);
    }
    if (host.color.image != VK_NULL_HANDLE) {
        recordColorOutput(primary, passes.picture.encoded(), host.color);
    }
    if (host.linear) {
        recordColorOutput(primary, *passes.picture.linear(), *host.linear);
    }
    if (host.motion) {
        recordColorOutput(primary, passes.motion->image(), *host.motion);
    }
}

void recordReadback(const gpu::Device& device, const FramePasses& passes, VkCommandBuffer commands,
                    FrameCopy copy) {
    const vk::CommandBuffer primary(commands);
    device.beginLabel(primary, "read-back");
    passes.readback.record(primary,
                           {.color = passes.picture.encoded(),
                            .gbuffer = passes.gbuffer(),
                            .linear = passes.picture.linear(),
                            .motion = passes.motion != nullptr ? &passes.motion->image() : nullptr,
                            .shadowMask = passes.shadows != nullptr ? &passes.shadows->mask() : nullptr},
                           copy);
    if (passes.translucent != nullptr) {
        passes.translucent->recordReadback(primary);
    }
    recordHostBarrier(primary);
    device.endLabel(primary);
}

Frame fetch(const FramePasses& passes, const FrameSlot& slot) {
    Frame frame;
    frame.camera = slot.view.camera;
    frame.cascades = slot.view.ranges();
    frame.anchorsView = slot.view.anchorsView();
    passes.readback.fetch(*slot.copy, frame);
    if (passes.translucent != nullptr) {
        frame.fragmentCounts = passes.translucent->fragmentCounts();
    }
    frame.stats = slot.stats;
    return frame;
}

} // namespace cdr::render
