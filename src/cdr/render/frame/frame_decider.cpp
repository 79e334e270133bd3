#include <cdr/render/frame/frame_decider.h>
#include <cdr/render/renderer_setup.h>
#include <cdr/visibility/cull_cells.h>

#include <span>
#include <utility>

namespace cdr::render {

namespace {

std::span<const depth::Interval> hostIntervals(const Delivery& delivery) {
    return delivery.host != nullptr ? std::span<const depth::Interval>(delivery.host->occupied)
                                    : std::span<const depth::Interval>();
}

} // namespace

FrameDecider::FrameDecider(const gpu::Device& device, const DrawnScene& drawn, FrameEquipment& equipment,
                           platform::WorkerPool& workers)
    : m_device(device),
      m_drawn(drawn),
      m_equipment(equipment),
      m_workers(workers) {
    if (equipment.options().motion) {
        m_motion.emplace();
    }
}

void FrameDecider::decide(FrameSlot& slot, const scene::Camera& camera, const Delivery& delivery) {
    depth::Cascades cut = m_equipment.passes().cutter.split().previous(); // first, since this copy may fail
    slot.before = {.view = std::move(slot.view),
                   .stats = slot.stats,
                   .copy = slot.copy,
                   .cut = std::move(cut),
                   .isMotionFollowed = false};
    try {
        platform::StageWatch watch(m_equipment.options().trace);
        decideView(slot, camera, delivery, watch);
        decideInputs(slot, delivery, watch);
    } catch (...) {
        takeBack(slot);
        throw;
    }
}

void FrameDecider::takeBack(FrameSlot& slot) {
    slot.view = std::move(slot.before.view);
    slot.stats = slot.before.stats;
    slot.copy = slot.before.copy;
    m_equipment.passes().cutter.split().takeBack(std::move(slot.before.cut));
    if (slot.before.isMotionFollowed) {
        forgetMotion();
    }
}

void FrameDecider::decideAgain(FrameSlot& slot) {
    if (slot.path->needsVisible()) {
        cull(slot.view); // by now the list may be a later frame's
    }
    if (slot.inputs->translucent) {
        const TranslucentPass& pass = *m_equipment.passes().translucent;
        pass.prepareAgain(*slot.inputs->translucent, slot.view, subPixelBits(m_device, m_equipment.options()),
                          m_workers);
        slot.stats.translucency = pass.decided(*slot.inputs->translucent);
    }
}

void FrameDecider::decideView(FrameSlot& slot, const scene::Camera& camera, const Delivery& delivery,
                              platform::StageWatch& watch) {
    FrameCutter& cutter = m_equipment.passes().cutter;
    const RenderOptions& options = m_equipment.options();
    slot.view = cutter.look(camera);
    if (delivery.shared == nullptr && readsVisible(slot)) {
        cull(slot.view);
    }
    slot.stats = {};
    slot.stats.lostMetallicRoughness =
        m_drawn.uploaded.hasMetallicRoughness() && !keepsMetallicRoughness(options);
    slot.stats.lostEmission = m_drawn.uploaded.hasEmission() && !keepsEmission(options);
    slot.stats.times.cullMs = watch.lap("cull");
    if (delivery.shared != nullptr) {
        cutter.take(slot.view, *delivery.shared);
    } else {
        cutter.cut(slot.view, m_visible, hostIntervals(delivery));
    }
}

void FrameDecider::decideInputs(FrameSlot& slot, const Delivery& delivery, platform::StageWatch& watch) {
    FramePasses& passes = m_equipment.passes();
    passes.shading.update(slot.inputs->shading, m_drawn.scene, slot.view);
    if (slot.inputs->motion) {
        decideMotion(slot);
    }
    slot.stats.times.splitMs = watch.lap("split");
    if (slot.inputs->shadows) {
        passes.shadows->prepare(*slot.inputs->shadows, slot.view,
                                {.visible = m_visible, .occupied = hostIntervals(delivery)},
                                subPixelBits(m_device, m_equipment.options()), m_workers);
        slot.stats.shadows = {.maps = slot.inputs->shadows->views.size(),
                              .casters = slot.inputs->shadows->casters.draws()};
        slot.stats.times.shadowsMs = watch.lap("shadows");
    }
    if (auto* byCpu = findIn<OcclusionCulling>(passes.occlusion)) {
        slot.stats.occluders = byCpu->drop(slot.view, m_workers, m_visible);
        slot.stats.times.occludersMs = watch.lap("occluders");
    }
    if (slot.inputs->translucent) {
        decideTranslucent(slot, delivery);
        slot.stats.times.translucentMs = watch.lap("translucent draws");
    }
}

void FrameDecider::decideMotion(FrameSlot& slot) {
    slot.before.isMotionFollowed = true;
    m_equipment.passes().motion->update(*slot.inputs->motion, m_drawn, slot.view,
                                        m_motion->follow(m_drawn, slot.view.camera));
}

void FrameDecider::decideTranslucent(FrameSlot& slot, const Delivery& delivery) {
    using AfterRefusal = TranslucentPass::AfterRefusal;
    TranslucentPass::Slot& translucent = *slot.inputs->translucent;
    const TranslucentPass& pass = *m_equipment.passes().translucent;
    pass.prepare(translucent, slot.view,
                 delivery.awaited == Awaited::yes ? AfterRefusal::sorted : AfterRefusal::weighted,
                 subPixelBits(m_device, m_equipment.options()), m_workers);
    slot.stats.translucency = pass.decided(translucent);
    if (translucent.shadows) {
        slot.stats.shadows.maps += translucent.shadows->maps();
        slot.stats.shadows.casters += translucent.shadows->casters();
    }
}

void FrameDecider::followMotion(const scene::Camera& camera) {
    if (m_motion) {
        m_motion->follow(m_drawn, camera);
    }
}

void FrameDecider::followCut(const scene::Camera& camera) {
    FrameCutter& cutter = m_equipment.passes().cutter;
    if (cutter.split().needsVisible()) {
        FrameView view = cutter.look(camera);
        cull(view);
        cutter.cut(view, m_visible);
    }
}

void FrameDecider::forgetFrames() {
    m_equipment.passes().forgetFrames();
    forgetMotion();
}

void FrameDecider::forgetMotion() {
    if (m_motion) {
        m_motion->forget();
    }
}

bool FrameDecider::readsVisible(const FrameSlot& slot) const {
    return slot.path->needsVisible() || m_equipment.passes().cutter.split().needsVisible() ||
           slot.inputs->shadows;
}

void FrameDecider::cull(const FrameView& view) {
    visibility::cullCells(m_drawn.uploaded.cells(m_workers), view.camera, view.frustum, m_workers, m_visible);
}

} // namespace cdr::render
