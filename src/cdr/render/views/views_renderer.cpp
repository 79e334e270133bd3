#include "../frame_slot.h"

#include <cdr/base/error.h>
#include <cdr/gpu/commands.h>
#include <cdr/host/stage_watch.h>
#include <cdr/host/stopwatch.h>
#include <cdr/render/frame_split.h>
#include <cdr/render/views/views_renderer.h>
#include <cdr/visibility/cull_cells.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cdr::render {

namespace {

void requireCameras(std::span<const scene::Camera> cameras, std::size_t views) {
    if (cameras.size() != views) {
        throw base::InputError(fmt::format("{} cameras were given for {} views", cameras.size(), views));
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
        throw base::InputError(fmt::format("{} frames were given for {} views", frames.size(), views));
    }
    std::vector<VkImage> images;
    for (const HostFrame& frame : frames) {
        images.push_back(frame.color.image);
        images.push_back(frame.depth ? frame.depth->image.image : VK_NULL_HANDLE);
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
        gpu::waitForQueue(device);
    } catch (...) { // the first error is told
    }
}

} // namespace

template <typename Make>
ViewsRenderer::ViewsRenderer(std::size_t views, const RenderOptions& options, const Make& make)
    : m_split(std::make_unique<FrameSplit>(options.technique)) {
    if (views == 0 || views > kMaxViews) {
        throw base::InputError(fmt::format("views must be 1 to {}, not {}", kMaxViews, views));
    }
    for (std::size_t view = 0; view < views; ++view) {
        m_renderers.push_back(make());
    }
}

ViewsRenderer::ViewsRenderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
                             const RenderOptions& options, std::size_t views)
    : ViewsRenderer(views, options,
                    [&] { return std::make_unique<Renderer>(device, scene, gpuScene, options); }) {}

ViewsRenderer::ViewsRenderer(const gpu::Device& device, GpuScene& live, const RenderOptions& options,
                             std::size_t views)
    : ViewsRenderer(views, options, [&] { return std::make_unique<Renderer>(device, live, options); }) {}

ViewsRenderer::~ViewsRenderer() = default;

depth::Cascades ViewsRenderer::look(Cameras cameras, std::span<const depth::Interval> occupied) {
    bool isRead = m_split->needsVisible();
    std::vector<FrameView> views;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        Renderer& renderer = *m_renderers[i];
        renderer.followScene();
        views.push_back(renderer.m_passes->cutter.look(cameras[i]));
        isRead = isRead || renderer.readsVisible(renderer.m_passes->slots.front());
    }
    std::vector<visibility::VisibleCells*> visible;
    for (const auto& renderer : m_renderers) {
        visible.push_back(renderer->m_visible.get());
    }
    if (isRead) {
        std::vector<visibility::SphereTest> tests;
        for (const FrameView& view : views) {
            tests.emplace_back(view.camera, view.frustum);
        }
        Renderer& first = *m_renderers.front();
        visibility::cullCells(first.m_drawn.uploaded.cells(first.m_workers), tests, first.m_workers, visible);
    }
    const std::vector<const visibility::VisibleCells*> seen(visible.begin(), visible.end());
    return m_split->cut(views.front().camera, views.front().frustum, seen, occupied);
}

void ViewsRenderer::launch(Cameras cameras, const Launch& how) {
    requireCameras(cameras, views());
    // What settling draws again lists what it shows, and must not come between the begin of a view's targets and its draws.
    for (const auto& renderer : m_renderers) {
        renderer->settle(renderer->slotOf(renderer->m_frames));
    }
    const host::Stopwatch watch;
    depth::Cascades before = m_split->previous();
    const depth::Cascades cascades = look(cameras, occupiedBy(how.hosts));
    const double lookMs = watch.milliseconds();
    std::vector<Renderer::Delivery> deliveries;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        deliveries.push_back({.destination = how.destination, .shared = &cascades});
        deliveries.back().isAwaited = how.isAwaited;
        deliveries.back().host = how.hosts.empty() ? nullptr : &how.hosts[i];
    }
    deliveries.front().sync.waits = how.sync.waits;
    deliveries.back().sync.signals = how.sync.signals;
    try {
        if (mayBeTogether(how)) {
            launchTogether(cameras, deliveries);
        } else {
            launchInTurn(cameras, deliveries);
        }
    } catch (...) {
        m_split->takeBack(std::move(before));
        throw;
    }
    lastSlot(0).stats.times.cullMs += lookMs;
}

bool ViewsRenderer::mayBeTogether(const Launch& how) const {
    if (how.hosts.empty()) {
        return !options().deviceClock;
    }
    return std::all_of(how.hosts.begin(), how.hosts.end(),
                       [&](const HostFrame& host) { return host.commands == how.hosts.front().commands; });
}

void ViewsRenderer::launchInTurn(Cameras cameras, std::span<const Renderer::Delivery> deliveries) {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        m_renderers[i]->run(cameras[i], deliveries[i]);
    }
}

void ViewsRenderer::launchTogether(Cameras cameras, std::span<Renderer::Delivery> deliveries) {
    std::vector<Renderer::Slot*> begun;
    std::size_t committed = 0;
    try {
        for (std::size_t i = 0; i < cameras.size(); ++i) {
            Renderer& renderer = *m_renderers[i];
            Renderer::Slot& slot = renderer.prepare(cameras[i], deliveries[i]);
            begun.push_back(&slot);
            host::StageWatch watch(options().trace);
            renderer.beginFrame(slot, deliveries[i], watch);
            if (i == 0) {
                for (const auto& each : m_renderers) {
                    each->beginTargets(slot.path->primary());
                }
            }
            renderer.recordDraws(slot);
            if (deliveries[i].host == nullptr) {
                renderer.submitDraws(slot, std::exchange(deliveries[i].sync.waits, {}), watch);
                deliveries[i].areDrawsSubmitted = true;
            } else {
                slot.stats.times.recordMs += watch.lap("record");
            }
        }
        for (std::size_t i = 0; i < cameras.size(); ++i) {
            host::StageWatch watch(options().trace);
            m_renderers[i]->finishFrame(*begun[i], deliveries[i], watch);
            m_renderers[i]->commit(*begun[i]);
            ++committed;
        }
    } catch (...) {
        if (deliveries.front().areDrawsSubmitted) {
            waitQuietly(m_renderers.front()->m_device);
        }
        for (std::size_t i = committed; i < begun.size(); ++i) {
            m_renderers[i]->abandon(*begun[i]);
        }
        throw;
    }
}

Renderer::Slot& ViewsRenderer::lastSlot(std::size_t view) const {
    const Renderer& renderer = *m_renderers[view];
    return renderer.slotOf(renderer.m_frames - 1);
}

std::vector<Frame> ViewsRenderer::render(Cameras cameras, FrameCopy copy) {
    launch(cameras, {.destination = copy == FrameCopy::color ? Renderer::Destination::hostColor
                                                             : Renderer::Destination::host,
                     .isAwaited = true});
    std::vector<Frame> frames;
    for (std::size_t view = 0; view < views(); ++view) {
        m_renderers[view]->waitFor(lastSlot(view));
        frames.push_back(m_renderers[view]->fetch(lastSlot(view)));
    }
    return frames;
}

std::vector<FrameStats> ViewsRenderer::draw(Cameras cameras) {
    launch(cameras, {.isAwaited = true});
    std::vector<FrameStats> stats;
    for (std::size_t view = 0; view < views(); ++view) {
        m_renderers[view]->waitFor(lastSlot(view));
        stats.push_back(lastSlot(view).stats);
    }
    return stats;
}

void ViewsRenderer::submit(Cameras cameras, const FrameSync& sync) {
    launch(cameras, {.sync = sync});
}

void ViewsRenderer::record(Cameras cameras, std::span<const HostFrame> frames) {
    requireCameras(cameras, views());
    requireFrames(frames, views());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        m_renderers[i]->requireRecordable(frames[i]);
    }
    for (const auto& renderer : m_renderers) {
        renderer->m_mayDrop = false; // the frames before were submitted
    }
    try {
        launch(cameras, {.hosts = frames});
    } catch (...) {
        dropRecorded(); // the views that were recorded before the error
        throw;
    }
}

void ViewsRenderer::dropRecorded() {
    for (const auto& renderer : m_renderers) {
        renderer->dropRecorded();
    }
}

void ViewsRenderer::finish() {
    for (const auto& renderer : m_renderers) {
        renderer->finish();
    }
}

void ViewsRenderer::skip(Cameras cameras) {
    requireCameras(cameras, views());
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        Renderer& renderer = *m_renderers[i];
        renderer.followScene();
        if (renderer.m_motion != nullptr) {
            renderer.m_motion->follow(renderer.m_drawn, cameras[i]);
        }
    }
    if (m_split->needsVisible()) {
        look(cameras, {});
    }
}

void ViewsRenderer::forgetFrames() {
    m_split->forget();
    for (const auto& renderer : m_renderers) {
        renderer->forgetFrames();
    }
}

Surfaces ViewsRenderer::surfaces(std::size_t view) const {
    return m_renderers[view]->surfaces();
}

void ViewsRenderer::resize(std::uint32_t width, std::uint32_t height) {
    finish();
    const std::uint32_t widthBefore = options().width;
    const std::uint32_t heightBefore = options().height;
    std::size_t resized = 0;
    try {
        for (const auto& renderer : m_renderers) {
            renderer->resize(width, height);
            ++resized;
        }
    } catch (...) {
        for (std::size_t view = 0; view < resized; ++view) {
            m_renderers[view]->resize(widthBefore, heightBefore);
        }
        throw;
    }
    m_split->forget();
}

} // namespace cdr::render
