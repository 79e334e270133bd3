#include <cdr/base/format_error.h>
#include <cdr/gpu/commands.h>
#include <cdr/platform/stage_watch.h>
#include <cdr/platform/stopwatch.h>
#include <cdr/render/frame/for_all.h>
#include <cdr/render/frame/frame_output.h>
#include <cdr/render/frame/frame_runner.h>
#include <cdr/render/frame_split.h>
#include <cdr/render/views/views_renderer.h>
#include <cdr/visibility/cull_cells.h>

#include <algorithm>
#include <utility>

namespace cdr::render {

namespace {

void requireCameras(std::span<const scene::Camera> cameras, std::size_t views) {
    if (cameras.size() != views) {
        throw base::inputError("{} cameras were given for {} views", cameras.size(), views);
    }
    for (const scene::Camera& camera : cameras) {
        scene::requireUsable(camera);
        const scene::Camera& first = cameras.front();
        if (camera.fovY != first.fovY || camera.nearView != first.nearView ||
            camera.farView != first.farView) {
            throw base::InputError("cameras of one frame must have the same field of view, near and far");
        }
    }
}

void requireFrames(std::span<const HostFrame> frames, std::size_t views) {
    if (frames.size() != views) {
        throw base::inputError("{} frames were given for {} views", frames.size(), views);
    }
    std::vector<VkImage> images;
    for (const HostFrame& frame : frames) {
        images.push_back(frame.color.image);
        images.push_back(frame.depth ? frame.depth->image.image : VK_NULL_HANDLE);
        images.push_back(frame.linear ? frame.linear->image : VK_NULL_HANDLE);
        images.push_back(frame.motion ? frame.motion->image : VK_NULL_HANDLE);
    }
    std::erase(images, VkImage(VK_NULL_HANDLE));
    std::sort(images.begin(), images.end());
    if (std::adjacent_find(images.begin(), images.end()) != images.end()) {
        throw base::InputError("frames of several views cannot be recorded into one image");
    }
}

/// By what all hosts draw.
std::vector<depth::Interval> occupiedBy(std::span<const HostFrame> hosts) {
    std::vector<depth::Interval> all;
    for (const HostFrame& host : hosts) {
        all.insert(all.end(), host.occupied.begin(), host.occupied.end());
    }
    return all;
}

/// Draws of a frame that ends with an error are on no fence, and their command buffers are about to be recorded anew.
void waitQuietly(const gpu::Device& device) {
    try {
        gpu::finishQueue(device);
    } catch (...) { // the first error is told
    }
}

} // namespace

/// What becomes of a frame of each camera.
struct ViewsRenderer::Launch {
    std::optional<FrameCopy> copy{};    ///< Delivery::copy
    FrameSync sync{};                   ///< of all views together
    std::span<const HostFrame> hosts{}; ///< by view, that they are recorded into; empty: they are submitted
    Awaited awaited = Awaited::no;
};

template <typename Make>
ViewsRenderer::ViewsRenderer(std::size_t views, const RenderOptions& options, const Make& make)
    : m_split(std::make_unique<FrameSplit>(options.technique)) {
    if (views == 0 || views > kMaxViews) {
        throw base::inputError("views must be 1 to {}, not {}", kMaxViews, views);
    }
    for (std::size_t view = 0; view < views; ++view) {
        m_views.push_back(make());
    }
}

ViewsRenderer::ViewsRenderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
                             const RenderOptions& options, std::size_t views)
    : ViewsRenderer(views, options, [&] {
          return std::make_unique<FrameRunner>(device, SceneFollower(device, scene, gpuScene), options);
      }) {}

ViewsRenderer::ViewsRenderer(const gpu::Device& device, GpuScene& live, const RenderOptions& options,
                             std::size_t views)
    : ViewsRenderer(views, options, [&] {
          return std::make_unique<FrameRunner>(device, SceneFollower(device, live), options);
      }) {}

ViewsRenderer::~ViewsRenderer() = default;

const RenderOptions& ViewsRenderer::options() const {
    return m_views.front()->options();
}

depth::Cascades ViewsRenderer::look(Cameras cameras, std::span<const depth::Interval> occupied) {
    bool isRead = m_split->needsVisible();
    std::vector<FrameView> views;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        FrameRunner& view = *m_views[i];
        view.followScene();
        views.push_back(view.passes().cutter.look(cameras[i]));
        isRead = isRead || view.decider().readsVisible();
    }
    std::vector<visibility::VisibleCells*> visible;
    for (const auto& view : m_views) {
        visible.push_back(&view->decider().visible());
    }
    if (isRead) {
        std::vector<visibility::SphereTest> tests;
        for (const FrameView& view : views) {
            tests.emplace_back(view.camera, view.frustum);
        }
        FrameRunner& first = *m_views.front();
        visibility::cullCells(first.drawn().uploaded.cells(first.workers()), tests, first.workers(), visible);
    }
    const std::vector<const visibility::VisibleCells*> seen(visible.begin(), visible.end());
    return m_split->cut(views.front().camera, views.front().frustum, seen, occupied);
}

void ViewsRenderer::launch(Cameras cameras, const Launch& how) {
    keepRecorded();
    requireCameras(cameras, views());
    // An error of a frame before comes before anything of this one is decided, in all views.
    for (const auto& view : m_views) {
        view->settle(view->slots().next());
    }
    const platform::Stopwatch watch;
    depth::Cascades before = m_split->previous();
    const depth::Cascades cascades =
        look(cameras, occupiedBy(how.hosts)); // where this fails, the last frame stays
    const double lookMs = watch.milliseconds();
    try {
        std::vector<Delivery> deliveries;
        for (std::size_t i = 0; i < cameras.size(); ++i) {
            deliveries.push_back({.copy = how.copy, .shared = &cascades});
            deliveries.back().awaited = how.awaited;
            deliveries.back().host = how.hosts.empty() ? nullptr : &how.hosts[i];
        }
        deliveries.front().sync.waits = how.sync.waits;
        deliveries.back().sync.signals = how.sync.signals;
        launchAll(cameras, deliveries, mayBeTogether(how));
        m_views.front()->slots().last()->stats.times.cullMs += lookMs;
    } catch (...) {
        m_split->takeBack(std::move(before));
        forgetMotion();
        throw;
    }
}

bool ViewsRenderer::mayBeTogether(const Launch& how) const {
    if (how.hosts.empty()) {
        return !options().deviceClock;
    }
    return std::all_of(how.hosts.begin(), how.hosts.end(),
                       [&](const HostFrame& host) { return host.commands == how.hosts.front().commands; });
}

void ViewsRenderer::launchAll(Cameras cameras, std::span<Delivery> deliveries, bool isTogether) {
    std::vector<FrameSlot*> begun;
    std::size_t committed = 0;
    try {
        // Deciding may wait for the device, and what is submitted may wait for the host.
        for (std::size_t i = 0; i < cameras.size(); ++i) {
            begun.push_back(&m_views[i]->prepare(cameras[i], deliveries[i]));
        }
        if (isTogether) {
            launchDraws(begun, deliveries);
        }
        for (; committed < begun.size(); ++committed) {
            FrameRunner& view = *m_views[committed];
            FrameSlot& slot = *begun[committed];
            if (isTogether) {
                platform::StageWatch watch(options().trace);
                view.finishFrame(slot, deliveries[committed], watch);
            } else {
                view.launch(slot, deliveries[committed]);
            }
            view.commit(slot);
        }
    } catch (...) {
        if (deliveries.front().draws == DrawsSubmitted::ahead) {
            waitQuietly(m_views.front()->device());
        }
        for (std::size_t i = committed; i < begun.size(); ++i) {
            m_views[i]->abandon(*begun[i]);
        }
        throw;
    }
}

void ViewsRenderer::launchDraws(std::span<FrameSlot* const> begun, std::span<Delivery> deliveries) {
    for (std::size_t i = 0; i < begun.size(); ++i) {
        FrameRunner& view = *m_views[i];
        FrameSlot& slot = *begun[i];
        platform::StageWatch watch(options().trace);
        view.begin(slot, deliveries[i], watch);
        if (i == 0) {
            for (const auto& each : m_views) {
                each->beginTargets(slot.path->primary());
            }
        }
        view.recordDraws(slot);
        if (deliveries[i].host == nullptr) {
            view.submitDraws(slot, std::exchange(deliveries[i].sync.waits, {}), watch);
            deliveries[i].draws = DrawsSubmitted::ahead;
        } else {
            slot.stats.times.recordMs += watch.lap("record");
        }
    }
}

const FrameSlot& ViewsRenderer::waitFor(FrameRunner& view) {
    FrameSlot& slot = *view.slots().last();
    try {
        view.waitFor(slot);
    } catch (...) {
        forgetFrames(); // of all views: they go on from one frame
        throw;
    }
    return slot;
}

std::vector<Frame> ViewsRenderer::render(Cameras cameras, FrameCopy copy) {
    launch(cameras, {.copy = copy, .awaited = Awaited::yes});
    std::vector<Frame> frames;
    for (const auto& view : m_views) {
        const FrameSlot& slot = waitFor(*view);
        frames.push_back(fetch(view->passes(), slot));
    }
    return frames;
}

std::vector<FrameStats> ViewsRenderer::draw(Cameras cameras) {
    launch(cameras, {.awaited = Awaited::yes});
    std::vector<FrameStats> stats;
    for (const auto& view : m_views) {
        stats.push_back(waitFor(*view).stats);
    }
    return stats;
}

void ViewsRenderer::submit(Cameras cameras, const FrameSync& sync) {
    launch(cameras, {.sync = sync});
}

void ViewsRenderer::record(Cameras cameras, std::span<const HostFrame> frames) {
    keepRecorded();
    requireCameras(cameras, views());
    requireFrames(frames, views());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        m_views[i]->requireRecordable(frames[i]);
    }
    try {
        launch(cameras, {.hosts = frames});
    } catch (...) {
        dropRecorded(); // the views that were recorded before the error
        throw;
    }
}

void ViewsRenderer::keepRecorded() {
    for (const auto& view : m_views) {
        view->slots().keepRecorded();
    }
}

void ViewsRenderer::dropRecorded() {
    for (const auto& view : m_views) {
        view->dropRecorded();
    }
}

void ViewsRenderer::finish() {
    forAll(m_views, [](FrameRunner& view) { view.finish(); });
}

void ViewsRenderer::skip(Cameras cameras) {
    keepRecorded();
    requireCameras(cameras, views());
    try {
        for (std::size_t i = 0; i < cameras.size(); ++i) {
            m_views[i]->followScene();
            m_views[i]->decider().followMotion(cameras[i]);
        }
        if (m_split->needsVisible()) {
            look(cameras, {});
        }
    } catch (...) {
        forgetMotion();
        throw;
    }
}

void ViewsRenderer::forgetFrames() {
    m_split->forget();
    for (const auto& view : m_views) {
        view->decider().forgetFrames();
    }
}

void ViewsRenderer::forgetMotion() {
    for (const auto& view : m_views) {
        view->decider().forgetMotion();
    }
}

Surfaces ViewsRenderer::surfaces(std::size_t view) const {
    FrameRunner& frames = *m_views[view];
    frames.nameSurfaces();
    return surfacesOf(frames.passes(), frames.slots().last());
}

FrameStats ViewsRenderer::lastStats(std::size_t view) const {
    return m_views[view]->slots().lastStats();
}

void ViewsRenderer::resize(std::uint32_t width, std::uint32_t height) {
    finish();
    std::vector<FrameEquipment::Made> made; // of all views first, since this may throw
    for (const auto& view : m_views) {
        made.push_back(view->resized(width, height));
    }
    for (std::size_t view = 0; view < made.size(); ++view) {
        m_views[view]->take(std::move(made[view]));
    }
    m_split->forget();
}

} // namespace cdr::render
