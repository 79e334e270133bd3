#include <cdr/gpu/commands.h>
#include <cdr/render/frame/frame_output.h>
#include <cdr/render/frame/frame_recorder.h>
#include <cdr/render/output/host_commands.h>
#include <cdr/render/shading/finish.h>
#include <cdr/render/targets/gbuffer_rendering.h>

#include <variant>

namespace cdr::render {

void FrameRecorder::begin(FrameSlot& slot, const Delivery& delivery, const visibility::VisibleCells& visible,
                          platform::StageWatch& watch) const {
    slot.host = delivery.host != nullptr ? hostCommands(m_device, m_options, slot.view, *delivery.host)
                                         : HostCommands{};
    slot.copy = delivery.copy;
    slot.path->bin(slot.view, visible, slot.stats);
    slot.stats.times.binMs = watch.lap("bin");
    slot.commands.clear();
    if (slot.readPath != nullptr && isRead(slot, delivery)) {
        recordReadSurfaces(slot, delivery.host, visible);
    }
    slot.path->begin(slot.view, slot.host);
    slot.stats.times.recordMs = 0.0;
}

void FrameRecorder::beginTargets(VkCommandBuffer primary, HostReads reads) const {
    if (reads == HostReads::anyStage) {
        waitForHostReads(primary);
    }
    m_passes.drawnTargets().begin(primary);
}

void FrameRecorder::recordDraws(FrameSlot& slot) const {
    if (m_passes.litTargets != nullptr) {
        slot.view.clearColor = glm::vec4(
            shownBackground(m_drawn.scene.background, m_options.effects.finish, Daylight::absent), 1.0f);
    }
    m_passes.drawnTargets().record(*slot.path, slot.view);
}

void FrameRecorder::endDraws(FrameSlot& slot) const {
    const std::span<const vk::CommandBuffer> drawn = slot.path->endDraws(slot.view);
    slot.commands.insert(slot.commands.end(), drawn.begin(), drawn.end());
}

void FrameRecorder::recordRest(FrameSlot& slot, const Delivery& delivery) const {
    if (m_passes.litTargets == nullptr) {
        recordShading(slot);
    }
    recordSurfaces(slot, delivery);
    if (slot.inputs->translucent) {
        m_passes.translucent->record(slot.path->primary(), *slot.inputs->translucent);
    }
    m_passes.picture.finish(slot.path->primary());
    if (delivery.copy) {
        recordReadback(m_device, m_passes, slot.path->primary(), *delivery.copy);
    }
    if (delivery.host != nullptr) {
        recordOutputs(m_device, m_passes, slot, *delivery.host);
    }
    const std::span<const vk::CommandBuffer> drawn = slot.path->end(slot.view);
    slot.commands.insert(slot.commands.end(), drawn.begin(), drawn.end());
}

void FrameRecorder::recordReadSurfaces(FrameSlot& slot, const HostFrame* host,
                                       const visibility::VisibleCells& visible) const {
    FrameStats counted; // the frame's are those of the draws that are lit
    slot.readPath->bin(slot.view, visible, counted);
    const HostCommands into{.into = host != nullptr ? host->commands : nullptr, .draw = {}};
    slot.readPath->begin(slot.view, into);
    m_passes.targets.begin(slot.readPath->primary());
    m_passes.targets.record(*slot.readPath, slot.view);
    gpu::pipelineBarrier(slot.readPath->primary(), {readBarrier(m_passes.targets.gbuffer())});
    const std::span<const vk::CommandBuffer> commands = slot.readPath->end(slot.view);
    slot.commands.assign(commands.begin(), commands.end());
}

void FrameRecorder::recordShading(FrameSlot& slot) const {
    if (m_passes.resolve != nullptr) {
        slot.inputs->shading.setFacets(slot.path->facets());
        if (slot.inputs->shadows) {
            slot.inputs->shadows->inputs.setTexels(ShadingInputs::kFacetsBinding, slot.path->facets());
        }
    }
    if (const auto* focus = std::get_if<std::unique_ptr<FocusLayers>>(&m_passes.ownTargets)) {
        (*focus)->light(slot.path->primary(), slot.inputs->shading, slot.inputs->focus);
    } else {
        m_passes.shading.begin(slot.path->primary(), slot.inputs->shading);
        if (slot.inputs->shadows) {
            m_passes.shadows->record(slot.path->primary(), *slot.inputs->shadows);
        }
        m_passes.shading.record(slot.path->primary(), slot.inputs->shading);
    }
}

void FrameRecorder::recordSurfaces(FrameSlot& slot, const Delivery& delivery) const {
    if (m_passes.resolve != nullptr && isRead(slot, delivery)) {
        const DrawPath& drawn = slot.readPath != nullptr ? *slot.readPath : *slot.path;
        slot.inputs->resolve.setTexels(ShadingInputs::kFacetsBinding, drawn.facets());
        m_passes.resolve->pass.recordInto(slot.path->primary(), "resolve the G-buffer", slot.inputs->resolve,
                                          m_passes.resolve->gbuffer);
    }
    if (slot.inputs->motion) {
        m_passes.motion->record(slot.path->primary(), *slot.inputs->motion);
    }
}

} // namespace cdr::render
