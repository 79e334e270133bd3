#pragma once

#include <cdr/gpu/device.h>
#include <cdr/platform/trace.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/renderer.h>

#include <options/views/views_drawer.h>
#include <options/views/views_plan.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace cdr::viewer {

/// What all renderers of an open scene share.
struct SceneOnDevice {
    const gpu::Device& device;
    const scene::Scene& scene;
    render::GpuScene& onDevice; ///< of `scene`, or of a world that began as it
};

/// What a renderer does with the frames before.
enum class FramesBefore : std::uint8_t {
    kept,
    forgotten, ///< render::Renderer::forgetFrames()
};

/// One renderer, of one eye or two, and its trace, made again when what it is made from changes.
class SideRenderer {
  public:
    /// Of two eyes, their frames beside each other.
    render::Frame render(const SceneOnDevice& set, render::RenderOptions options,
                         const options::ViewsPlan& plan, const scene::Camera& camera, render::FrameCopy copy,
                         FramesBefore before);
    /// Of the last frame.
    const platform::Trace& trace() const { return *m_trace; }
    void drop() { m_drawer.reset(); }

  private:
    render::RenderOptions m_asked;            ///< what it is made from, without the trace
    std::size_t m_viewsAsked = 0;             ///< the same
    std::unique_ptr<platform::Trace> m_trace; ///< outlives the renderer
    std::unique_ptr<options::ViewsDrawer> m_drawer;
};

} // namespace cdr::viewer
