#pragma once

#include <cdr/render/renderer.h>
#include <cdr/render/views/views_renderer.h>

#include <options/views/views_plan.h>

#include <cstddef>
#include <memory>
#include <variant>

namespace cdr::options {

/// Draws the frames of a ViewsPlan, of one view or of several at a time.
class ViewsDrawer {
  public:
    /// @param onDevice of `scene`, or of a world that began as it. What is given by reference must outlive this.
    /// @param views ViewsPlan::count(). base::InputError, base::RunError as render::Renderer.
    ViewsDrawer(const gpu::Device& device, const scene::Scene& scene, render::GpuScene& onDevice,
                const render::RenderOptions& options, std::size_t views);

    /// The frame of a camera; of several views, their frames beside each other.
    /// @param plan of as many views.
    render::Frame render(const ViewsPlan& plan, const scene::Camera& camera,
                         render::FrameCopy copy = render::FrameCopy::everything);
    /// Goes past a frame, as render::Renderer::skip().
    void skip(const ViewsPlan& plan, const scene::Camera& camera);
    /// As render::Renderer::forgetFrames().
    void forgetFrames();

  private:
    std::variant<std::unique_ptr<render::Renderer>, std::unique_ptr<render::ViewsRenderer>> m_renderer;
};

} // namespace cdr::options
