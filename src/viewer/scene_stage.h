#pragma once

#include "render_request.h"

#include <cdr/gpu/device.h>
#include <cdr/render/gpu_scene.h>

#include <array>
#include <memory>
#include <string>

namespace cdr::viewer {

/// One renderer, made anew when what it is made from changes.
class SideRenderer {
  public:
    render::Frame render(const gpu::Device& device, const scene::Scene& scene, const render::GpuScene& onDevice,
                         const render::RenderOptions& options, const scene::Camera& camera,
                         render::FrameCopy copy);
    void drop() { m_renderer.reset(); }

  private:
    std::unique_ptr<render::Renderer> m_renderer;
};

/// The open scene on its device, and the renderers that answer requests. One thread's.
class SceneStage {
  public:
    /// The device must outlive the stage.
    explicit SceneStage(const gpu::Device& device) : m_device(device) {}

    /// Opens what the request names unless it is open, and renders it. base::InputError or base::RunError say
    /// what cannot be; the scene that was open then stays.
    RenderResult answer(const RenderRequest& request);

    const std::string& sceneName() const { return m_sceneName; }

  private:
    struct OnStage {
        std::shared_ptr<const scene::OpenedScene> opened;
        render::GpuScene onDevice;
    };
    void open(const RenderRequest& request);

    const gpu::Device& m_device;
    std::string m_sceneName;
    std::unique_ptr<OnStage> m_scene;
    std::array<SideRenderer, 2> m_sides;
};

} // namespace cdr::viewer
