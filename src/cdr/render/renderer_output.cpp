#include "frame_slot.h"

#include <cdr/render/output/color_output.h>

#include <memory>

namespace cdr::render {

Surfaces Renderer::surfaces() const {
    m_areSurfacesNamed = true;
    const auto imageOf = [](const gpu::Image& image, vk::ImageLayout layout) {
        return SurfaceImage{.image = image.handle(),
                            .view = image.view(),
                            .format = static_cast<VkFormat>(image.options().format),
                            .extent = image.options().extent,
                            .layout = static_cast<VkImageLayout>(layout)};
    };
    Surfaces surfaces{.color = imageOf(m_passes->picture.encoded(), vk::ImageLayout::eUndefined),
                      .gbuffer = {},
                      .motion = {},
                      .anchorsView = {}};
    if (m_passes->resolve == nullptr) {
        surfaces.gbuffer = imageOf(m_passes->targets.gbuffer(), vk::ImageLayout::eUndefined);
    }
    if (m_passes->motion != nullptr) {
        surfaces.motion = imageOf(m_passes->motion->image(), vk::ImageLayout::eUndefined);
    }
    if (m_frames > 0) {
        const Slot& last = slotOf(m_frames - 1);
        // As Picture::finish(), the passes that read the G-buffer and copies to main memory leave them.
        surfaces.color.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        if (surfaces.gbuffer.image != VK_NULL_HANDLE) {
            surfaces.gbuffer.layout = last.destination == Destination::host
                                          ? VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL
                                          : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
        }
        if (surfaces.motion.image != VK_NULL_HANDLE) {
            surfaces.motion.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        }
        surfaces.anchorsView = last.view.anchorsView();
    }
    return surfaces;
}

FrameStats Renderer::lastStats() const {
    return m_frames > 0 ? slotOf(m_frames - 1).stats : FrameStats();
}

void Renderer::recordOutputs(Slot& slot, const HostFrame& host) {
    const vk::CommandBuffer primary = slot.path->primary();
    if (host.depth) {
        if (m_passes->depthOutput == nullptr) {
            m_passes->depthOutput = std::make_unique<DepthOutput>(m_device);
        }
        if (!slot.inputs->depthOutput) {
            slot.inputs->depthOutput =
                m_passes->depthOutput->makeInputs(m_passes->gbuffer(), slot.inputs->shading);
        }
        m_passes->depthOutput->record(primary, *slot.inputs->depthOutput, *host.depth);
    }
    recordColorOutput(primary, m_passes->picture.encoded(), host.color);
    if (host.motion) {
        recordColorOutput(primary, m_passes->motion->image(), *host.motion);
    }
}

void Renderer::recordReadback(VkCommandBuffer commands, Destination destination) const {
    const vk::CommandBuffer primary(commands);
    m_device.beginLabel(primary, "read-back");
    m_passes->readback.record(
        primary,
        {.color = m_passes->picture.encoded(),
         .gbuffer = m_passes->gbuffer(),
         .motion = m_passes->motion != nullptr ? &m_passes->motion->image() : nullptr,
         .shadowMask = m_passes->shadows != nullptr ? &m_passes->shadows->mask() : nullptr},
        copyOf(destination));
    if (m_passes->translucent != nullptr) {
        m_passes->translucent->recordReadback(primary);
    }
    recordHostBarrier(primary);
    m_device.endLabel(primary);
}

Frame Renderer::fetch(const Slot& slot) const {
    Frame frame;
    frame.camera = slot.view.camera;
    frame.cascades = slot.view.ranges();
    frame.anchorsView = slot.view.anchorsView();
    m_passes->readback.fetch(copyOf(slot.destination), frame);
    if (m_passes->translucent != nullptr) {
        frame.fragmentCounts = m_passes->translucent->fragmentCounts();
    }
    frame.stats = slot.stats;
    return frame;
}

} // namespace cdr::render
