#include "frame_slot.h"

#include <cdr/gpu/commands.h>
#include <cdr/host/stage_watch.h>
#include <cdr/render/output/host_commands.h>
#include <cdr/render/shading/finish.h>
#include <cdr/render/targets/gbuffer_rendering.h>

#include <utility>
#include <vector>

namespace cdr::render {

void Renderer::launch(Slot& slot, const Delivery& delivery) {
    host::StageWatch watch(m_options.trace);
    beginFrame(slot, delivery, watch);
    beginTargets(slot.path->primary());
    recordDraws(slot);
    finishFrame(slot, delivery, watch);
}

Targets& Renderer::drawnTargets() const {
    return m_passes->litTargets != nullptr ? *m_passes->litTargets : m_passes->targets;
}

void Renderer::beginTargets(VkCommandBuffer primary) {
    if (m_areSurfacesNamed) {
        waitForHostReads(primary);
    }
    drawnTargets().begin(primary);
}

void Renderer::beginFrame(Slot& slot, const Delivery& delivery, host::StageWatch& watch) {
    slot.host = delivery.host != nullptr ? hostCommands(m_device, m_options, slot.view, *delivery.host)
                                         : HostCommands{};
    slot.destination = delivery.destination;
    slot.path->bin(slot.view, *m_visible, slot.stats);
    slot.stats.times.binMs = watch.lap("bin");
    slot.commands.clear();
    if (slot.readPath != nullptr && isRead(slot, delivery)) {
        recordReadSurfaces(slot, delivery.host);
    }
    slot.path->begin(slot.view, slot.host);
    slot.stats.times.recordMs = 0.0;
}

void Renderer::recordDraws(Slot& slot) {
    if (m_passes->litTargets != nullptr) {
        slot.view.clearColor =
            glm::vec4(finished(m_drawn.scene.background, m_options.effects.finish, Daylight::absent), 1.0f);
    }
    drawnTargets().record(*slot.path, slot.view);
}

void Renderer::submitDraws(Slot& slot, std::span<const VkSemaphoreSubmitInfo> waits,
                           host::StageWatch& watch) {
    const std::span<const vk::CommandBuffer> drawn = slot.path->endDraws(slot.view);
    slot.commands.insert(slot.commands.end(), drawn.begin(), drawn.end());
    slot.stats.times.recordMs += watch.lap("record");
    slot.submitted = host::Trace::Clock::now();
    gpu::submit(m_device, slot.commands, {}, waits);
    slot.commands.clear();
}

void Renderer::finishFrame(Slot& slot, const Delivery& delivery, host::StageWatch& watch) {
    const Destination destination = delivery.destination;
    if (m_passes->litTargets == nullptr) {
        shade(slot);
    }
    recordSurfaces(slot, delivery);
    if (slot.inputs->translucent) {
        m_passes->translucent->record(slot.path->primary(), *slot.inputs->translucent);
    }
    m_passes->picture.finish(slot.path->primary());
    if (destination != Destination::device) {
        recordReadback(slot.path->primary(), destination);
    }
    slot.recorded.reset();
    if (delivery.host != nullptr) {
        recordOutputs(slot, *delivery.host);
        slot.recorded = {.timeline = delivery.host->done, .value = delivery.host->doneValue};
    }
    const std::span<const vk::CommandBuffer> drawn = slot.path->end(slot.view);
    slot.commands.insert(slot.commands.end(), drawn.begin(), drawn.end());
    slot.stats.times.recordMs += watch.lap("record");
    if (!delivery.areDrawsSubmitted) {
        slot.submitted = host::Trace::Clock::now();
    }
    if (delivery.host == nullptr) {
        const auto timed = slot.clock ? slot.clock->around(slot.commands) : slot.commands;
        gpu::submit(m_device, timed, *slot.done, delivery.sync.waits, delivery.sync.signals);
    }
    slot.path->noteLaunched(); // not where the submission failed
    m_mayDrop = delivery.host != nullptr;
    slot.isPending = true;
}

void Renderer::dropRecorded() {
    if (!std::exchange(m_mayDrop, false) || m_frames == 0) {
        return;
    }
    Slot& slot = slotOf(m_frames - 1);
    slot.isPending = false;
    slot.path->noteDropped();
    if (auto* byDevice = findIn<DeviceOcclusion>(m_passes->occlusion)) {
        byDevice->forget(); // what it saw in that frame was never written
    }
}

bool Renderer::isRead(const Slot& slot, const Delivery& delivery) {
    const bool wantsDepth = delivery.host != nullptr && delivery.host->depth.has_value();
    return delivery.destination == Destination::host || wantsDepth || slot.inputs->motion;
}

void Renderer::recordReadSurfaces(Slot& slot, const HostFrame* host) {
    FrameStats counted; // the frame's are those of the draws that are lit
    slot.readPath->bin(slot.view, *m_visible, counted);
    slot.readPath->begin(slot.view, {.into = host != nullptr ? host->commands : nullptr, .draw = {}});
    m_passes->targets.begin(slot.readPath->primary());
    m_passes->targets.record(*slot.readPath, slot.view);
    gpu::pipelineBarrier(slot.readPath->primary(), {readBarrier(m_passes->targets.gbuffer())});
    const std::span<const vk::CommandBuffer> commands = slot.readPath->end(slot.view);
    slot.commands.assign(commands.begin(), commands.end());
}

void Renderer::shade(Slot& slot) {
    if (m_passes->resolve != nullptr) {
        slot.inputs->shading.setFacets(slot.path->facets());
        if (slot.inputs->shadows) {
            slot.inputs->shadows->inputs.setTexels(ShadingInputs::kFacetsBinding, slot.path->facets());
        }
    }
    if (const auto* focus = std::get_if<std::unique_ptr<FocusLayers>>(&m_passes->ownTargets)) {
        (*focus)->light(slot.path->primary(), slot.inputs->shading, slot.inputs->focus);
    } else {
        m_passes->shading.begin(slot.path->primary(), slot.inputs->shading);
        if (slot.inputs->shadows) {
            m_passes->shadows->record(slot.path->primary(), *slot.inputs->shadows);
        }
        m_passes->shading.record(slot.path->primary(), slot.inputs->shading);
    }
}

void Renderer::recordSurfaces(Slot& slot, const Delivery& delivery) {
    if (m_passes->resolve != nullptr && isRead(slot, delivery)) {
        const DrawPath& drawn = slot.readPath != nullptr ? *slot.readPath : *slot.path;
        m_passes->resolve->record(slot.path->primary(), slot.inputs->resolve, drawn.facets());
    }
    if (slot.inputs->motion) {
        m_passes->motion->record(slot.path->primary(), *slot.inputs->motion);
    }
}

} // namespace cdr::render
