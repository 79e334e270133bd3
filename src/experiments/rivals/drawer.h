#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/renderer.h>

#include <rivals/contender.h>
#include <rivals/rival.h>

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace cdr::experiments {

/// What a row of a table is measured by.
struct DrawnFrame {
    image::ImageU32 ids;     ///< object index + 1, 0 for background
    image::ImageRgba8 color; ///< empty where nothing is shaded
    std::size_t cascades = 1;
    double duplication = 1.0; ///< draws per visible instance
};

/// Draws frames of a scene: whole ones by the library's renderer, or ids and distances alone by a contender. So an
/// experiment measures a technique of the library and a rival in one way.
class Drawer {
  public:
    /// Whole frames.
    explicit Drawer(std::unique_ptr<render::Renderer> renderer);
    /// Ids and distances alone, by a rival or a technique of the library.
    /// @lifetime As rivals::Contender.
    /// @throws base::InputError as rivals::Contender: for what the device cannot draw, layers and masked materials.
    Drawer(const gpu::Device& device, const render::GpuScene& scene, const rivals::Competing& competing,
           const vk::Extent2D& extent, platform::WorkerPool& workers);

    bool shades() const { return std::holds_alternative<WholeFrames>(m_by); }

    /// Draws a frame and copies it.
    DrawnFrame render(const scene::Camera& camera);
    /// Draws a frame, waits for it and leaves it on the device: what is timed.
    render::FrameStats draw(const scene::Camera& camera);
    /// As render::Renderer::skip(). No rival depends on the frames before.
    void skip(const scene::Camera& camera);

    /// Of a drawer that shades.
    render::Renderer& renderer() { return *std::get<WholeFrames>(m_by); }

  private:
    using WholeFrames = std::unique_ptr<render::Renderer>;
    using IdsAlone = std::unique_ptr<rivals::Contender>;

    std::variant<WholeFrames, IdsAlone> m_by;
};

/// What a row is measured by, and what it is called.
struct NamedDrawer {
    std::string name;
    Drawer drawer;
};

/// One for each technique, which draws whole frames as `drawing` says, then one for each rival.
/// @lifetime As Drawer.
/// @throws base::InputError as render::Renderer and Drawer.
std::vector<NamedDrawer> makeDrawers(const gpu::Device& device, const render::GpuScene& scene,
                                     render::RenderOptions drawing,
                                     const std::vector<depth::NamedTechnique>& techniques,
                                     const std::vector<rivals::NamedRival>& rivalsBeside,
                                     platform::WorkerPool& workers);

} // namespace cdr::experiments
