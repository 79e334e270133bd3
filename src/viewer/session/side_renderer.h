#pragma once

#include <cdr/gpu/device.h>
#include <cdr/host/trace.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/renderer.h>

#include <memory>

namespace cdr::viewer {

/// What all renderers of an open scene share.
struct SceneOnDevice {
    const gpu::Device& device;
    const scene::Scene& scene;
    render::GpuScene& onDevice; ///< of `scene`, or of a world that began as it
};

/// One renderer and its trace, made anew when what it is made from changes.
class SideRenderer {
  public:
    /// @param forgets the frames before, see render::Renderer::forgetFrames().
    render::Frame render(const SceneOnDevice& set, render::RenderOptions options, const scene::Camera& camera,
                         render::FrameCopy copy, bool forgets);
    /// Of the last frame.
    const host::Trace& trace() const { return *m_trace; }
    void drop() { m_renderer.reset(); }

  private:
    render::RenderOptions m_asked;        ///< what the renderer is made from, without the trace
    std::unique_ptr<host::Trace> m_trace; ///< outlives the renderer
    std::unique_ptr<render::Renderer> m_renderer;
};

} // namespace cdr::viewer
