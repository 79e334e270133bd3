#include <cdr/gpu/commands.h>
#include <cdr/render/frame/slot_ring.h>

#include <fmt/format.h>

#include <utility>

namespace cdr::render {

SlotRing::SlotRing(const gpu::Device& device, const RenderOptions& options, const DrawPathFactory& paths,
                   const FramePasses& passes, platform::WorkerPool& workers, std::size_t lightRoom)
    : m_device(device),
      m_lightRoom(lightRoom) {
    for (std::size_t slot = 0; slot < options.framesInFlight; ++slot) {
        FrameSlot& begun = m_slots.emplace_back();
        begun.path = paths.make(workers, findIn<DeviceOcclusion>(passes.occlusion),
                                fmt::format("frame slot {}", slot));
        if (passes.litTargets != nullptr) {
            begun.readPath = std::move(begun.path);
            begun.path = paths.makeLit(workers, fmt::format("lit frame slot {}", slot));
        }
        begun.done = vk::Device(device.handle()).createFenceUnique({});
        if (options.deviceClock && gpu::DeviceClock::isThere(device)) {
            begun.clock.emplace(device, fmt::format("frame slot {}", slot));
        }
        begun.inputs = passes.makeInputs(lightRoom);
    }
}

std::vector<FrameSlot*> SlotRing::inOrder() {
    std::vector<FrameSlot*> slots;
    for (std::size_t age = m_slots.size(); age-- > 0;) {
        if (age < m_frames) {
            slots.push_back(&slotOf(m_frames - 1 - age));
        }
    }
    return slots;
}

void SlotRing::giveLightRoom(const FramePasses& passes, std::size_t room) {
    std::vector<std::unique_ptr<SlotInputs>> made; // those of all slots first, since this may throw
    for (std::size_t i = 0; i < m_slots.size(); ++i) {
        made.push_back(passes.makeInputs(room));
    }
    for (std::size_t i = 0; i < made.size(); ++i) {
        if (made[i]->translucent && made[i]->translucent->list) { // which may have grown
            made[i]->translucent->list.emplace(std::move(*m_slots[i].inputs->translucent->list));
        }
        m_slots[i].inputs = std::move(made[i]);
    }
    m_lightRoom = room;
}

void SlotRing::submitDraws(FrameSlot& slot, std::span<const VkSemaphoreSubmitInfo> waits) const {
    slot.submitted = platform::Trace::Clock::now();
    gpu::submit(m_device, slot.commands, {}, waits);
    slot.commands.clear();
}

void SlotRing::submit(FrameSlot& slot, const Delivery& delivery) {
    if (delivery.draws == DrawsSubmitted::withRest) {
        slot.submitted = platform::Trace::Clock::now();
    }
    slot.recorded.reset();
    if (delivery.host != nullptr) {
        slot.recorded = {.timeline = delivery.host->done, .value = delivery.host->doneValue};
    } else {
        const auto timed = slot.clock ? slot.clock->around(slot.commands) : slot.commands;
        gpu::submit(m_device, timed, *slot.done, delivery.sync.waits, delivery.sync.signals);
    }
    slot.path->noteLaunched(); // not where the submission failed
    m_mayDrop = delivery.host != nullptr;
    slot.isPending = true;
}

void SlotRing::wait(FrameSlot& slot) const {
    if (slot.recorded) {
        gpu::waitForTimeline(m_device, slot.recorded->timeline, slot.recorded->value);
    } else {
        gpu::waitAndReset(m_device, *slot.done);
    }
    slot.isPending = false; // before a call that may fail: nothing signals the fence again
    if (!slot.recorded && slot.clock) {
        slot.stats.times.deviceMs = slot.clock->lastMs();
    }
}

void SlotRing::commit(FrameSlot& slot) {
    slot.before = {};
    ++m_frames;
}

FrameSlot* SlotRing::drop() {
    if (!std::exchange(m_mayDrop, false) || m_frames == 0) {
        return nullptr;
    }
    FrameSlot& slot = slotOf(m_frames - 1);
    slot.isPending = false;
    slot.path->noteDropped();
    return &slot;
}

} // namespace cdr::render
