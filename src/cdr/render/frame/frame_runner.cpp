#include <cdr/base/error.h>
#include <cdr/gpu/commands.h>
#include <cdr/render/frame/for_all.h>
#include <cdr/render/frame/frame_runner.h>
#include <cdr/render/output/host_commands.h>

namespace cdr::render {

namespace {

platform::WorkerPool& prepared(platform::WorkerPool& workers, const RenderOptions& options) {
    workers.setTrace(options.trace);
    if (options.schedule) {
        workers.setSchedule(*options.schedule);
    }
    return workers;
}

} // namespace

FrameRunner::FrameRunner(const gpu::Device& device, const SceneFollower& scene, const RenderOptions& options)
    : m_device(device),
      m_scene(scene),
      m_workers(options.threads, options.placement),
      m_equipment(device, m_scene.drawn(), prepared(m_workers, options), options),
      m_decider(device, m_scene.drawn(), m_equipment, m_workers) {
    if (options.motion) {
        m_scene.keepLastVertices();
    }
}

FrameRunner::~FrameRunner() {
    try {
        settleAll();
    } catch (...) {
        // Nobody waits for these frames any more; a lost device is reported where somebody does.
    }
}

FrameSlot& FrameRunner::run(const scene::Camera& camera, const Delivery& delivery) {
    FrameSlot& slot = prepare(camera, delivery);
    try {
        launch(slot, delivery);
    } catch (...) {
        abandon(slot);
        throw;
    }
    commit(slot);
    return slot;
}

void FrameRunner::skip(const scene::Camera& camera) {
    slots().keepRecorded(); // it was submitted, also where this is refused
    scene::requireUsable(camera);
    followScene();
    try {
        m_decider.followMotion(camera);
        m_decider.followCut(camera);
    } catch (...) {
        m_decider.forgetMotion();
        throw;
    }
}

void FrameRunner::requireRecordable(const HostFrame& frame) {
    render::requireRecordable(m_device, options(), frame);
    followScene(); // what was added may emit light
    if (frame.draw && m_equipment.needs().kept.emission) {
        throw base::InputError("a host cannot draw beside surfaces that emit light or have occlusion "
                               "textures, nor where these are prepared for");
    }
}

// NOLINTNEXTLINE(readability-make-member-function-const): it gives a frame up
void FrameRunner::dropRecorded() {
    if (slots().drop() == nullptr) {
        return;
    }
    if (auto* byDevice = findIn<DeviceOcclusion>(passes().occlusion)) {
        byDevice->forget(); // what it saw in that frame was never written
    }
}

FrameEquipment::Made FrameRunner::resized(std::uint32_t width, std::uint32_t height) {
    finish();
    followScene(); // paths that are made anew look at the scene as it is
    return m_equipment.resized(width, height);
}

void FrameRunner::followScene() {
    m_scene.update();
    m_scene.followFacets(m_equipment.paths(), options());
    const SceneNeeds needs = needsOf(drawn(), options());
    if (needs != m_equipment.needs()) {
        settleAll();
        if (m_reads == HostReads::anyStage) {
            gpu::waitForQueue(m_device); // a host may still read the images that end here
        }
        m_equipment.follow(needs);
    }
    if (m_scene.isChanged()) {
        m_equipment.paths().followKinds();
    }
    const std::size_t lights = drawn().scene.lights.size();
    if (lights > slots().lightRoom()) {
        settleAll();
        m_equipment.giveLightRoom(lights);
    }
    m_scene.noteFollowed();
}

FrameSlot& FrameRunner::prepare(const scene::Camera& camera, const Delivery& delivery) {
    slots().keepRecorded();
    scene::requireUsable(camera);
    followScene();
    FrameSlot& slot = slots().next();
    settle(slot);
    m_decider.decide(slot, camera, delivery);
    slot.revision = m_scene.revision();
    return slot;
}

void FrameRunner::launch(FrameSlot& slot, const Delivery& delivery) {
    platform::StageWatch watch(options().trace);
    begin(slot, delivery, watch);
    beginTargets(slot.path->primary());
    recordDraws(slot);
    finishFrame(slot, delivery, watch);
}

void FrameRunner::begin(FrameSlot& slot, const Delivery& delivery, platform::StageWatch& watch) {
    recorder().begin(slot, delivery, m_decider.visible(), watch);
}

void FrameRunner::submitDraws(FrameSlot& slot, std::span<const VkSemaphoreSubmitInfo> waits,
                              platform::StageWatch& watch) {
    recorder().endDraws(slot);
    slot.stats.times.recordMs += watch.lap("record");
    slots().submitDraws(slot, waits);
}

void FrameRunner::finishFrame(FrameSlot& slot, const Delivery& delivery, platform::StageWatch& watch) {
    recorder().recordRest(slot, delivery);
    slot.stats.times.recordMs += watch.lap("record");
    slots().submit(slot, delivery);
}

bool FrameRunner::settle(FrameSlot& slot) {
    if (!slot.isPending) {
        return true;
    }
    slots().wait(slot);
    return hasRoomSufficed(slot);
}

void FrameRunner::complete(FrameSlot& slot) {
    while (!settle(slot)) {
        // A frame that was submitted without a wait cannot be drawn again once the scene changed. It must not
        // be drawn over the images of a later one. One that a host recorded has gone into the host's images.
        const bool isCurrent = m_scene.isCurrent(slot.revision);
        const bool isLast = &slot == slots().last();
        if (isCurrent && isLast && !slot.recorded) {
            m_decider.decideAgain(slot);
            launch(slot, {.copy = slot.copy});
        }
    }
}

bool FrameRunner::hasRoomSufficed(FrameSlot& slot) const {
    const bool opaqueSufficed = slot.path->settle(slot.stats);
    const bool blendedSufficed =
        !slot.inputs->translucent ||
        passes().translucent->settle(*slot.inputs->translucent, slot.stats.translucency);
    return opaqueSufficed && blendedSufficed;
}

void FrameRunner::waitFor(FrameSlot& slot) {
    try {
        complete(slot);
    } catch (...) {
        m_decider.forgetFrames(); // nobody gets this one, so nothing is measured from it
        throw;
    }
    const auto done = platform::Trace::Clock::now();
    slot.stats.times.executeMs = platform::millisecondsBetween(slot.submitted, done);
    if (options().trace != nullptr) {
        options().trace->addStage("execute", slot.submitted, done);
    }
}

void FrameRunner::finish() {
    forAll(slots().inOrder(), [this](FrameSlot& slot) { complete(slot); });
}

void FrameRunner::settleAll() {
    forAll(slots().inOrder(), [this](FrameSlot& slot) { settle(slot); });
}

} // namespace cdr::render
