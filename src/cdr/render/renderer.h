#pragma once

#include <cdr/base/worker_pool.h>
#include <cdr/depth/technique.h>
#include <cdr/gpu/commands.h>
#include <cdr/render/cascade_recorder.h>
#include <cdr/render/frame.h>
#include <cdr/render/frame_split.h>
#include <cdr/render/geometry_pass.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/readback.h>
#include <cdr/render/shading_pass.h>
#include <cdr/render/targets.h>
#include <cdr/scene/bin.h>
#include <cdr/scene/cull.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace cdr::render {

struct RenderOptions {
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    depth::Technique technique;
    TargetsChoice targets = TargetsKind::single;
    std::size_t threads = 1; ///< that cull, bin and record, the caller's included
    Batching batching = Batching::instanced;
    /// Receives every frame's stages and jobs; must have `threads` tracks and outlive the renderer. Null for
    /// none.
    base::Trace* trace = nullptr;
};

/// Renders a scene with one technique into one kind of targets, frame by frame.
///
/// Data flows one way: camera -> cull -> split -> bin -> record on workers -> execute -> shade -> Frame.
class Renderer {
  public:
    /// The device, the scene and its GpuScene must outlive the renderer.
    /// base::InputError for a picture of no or too many pixels or a depth format the device lacks;
    /// base::RunError when its memory does not suffice, with both figures.
    Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
             const RenderOptions& options);

    /// Renders one frame, waits for it and copies it to the host. base::InputError for an unusable camera or
    /// split.
    Frame render(const scene::Camera& camera);

    /// Renders one frame and waits for it, but leaves it on the device: what experiments time.
    FrameStats draw(const scene::Camera& camera);

    const RenderOptions& options() const { return m_options; }

  private:
    struct Staged; ///< what the CPU stages hand on
    void stage(const scene::Camera& camera, Staged& staged, FrameStats& stats);
    void growRecords(std::size_t draws);
    enum class Destination { device, host };
    FrameStats run(const scene::Camera& camera, Staged& staged, Destination destination);
    vk::CommandBuffer recordPrimary(std::size_t cascades, Destination destination);
    void recordReadback(vk::CommandBuffer primary) const;
    Frame fetch(const Staged& staged) const;

    const gpu::Device& m_device;
    const scene::Scene& m_scene;
    const GpuScene& m_gpuScene;
    RenderOptions m_options;
    vk::Extent2D m_extent;
    double m_aspect;
    FrameSplit m_split;
    base::WorkerPool m_workers;
    GeometryPass m_geometry;
    std::unique_ptr<Targets> m_targets;
    ShadingPass m_shading;
    Readback m_colorCopy;
    Readback m_surfaceCopy;
    CascadeRecorder m_recorder;
    gpu::CommandPool m_primaryPool;

    // Kept from frame to frame so that a warm frame allocates nothing.
    scene::VisibleList m_visible;
    scene::DrawLists m_lists;
    gpu::Buffer m_records;
    vk::UniqueDescriptorPool m_recordPool;
    vk::DescriptorSet m_recordSet;
};

} // namespace cdr::render
