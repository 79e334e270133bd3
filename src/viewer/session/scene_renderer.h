#pragma once

#include "side_renderer.h"

#include <scenes/moving_scene.h>
#include <viewer/state/flip_window.h>
#include <viewer/state/requests/open_progress.h>
#include <viewer/state/requests/render_request.h>

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace cdr::viewer {

/// The open scene on its device, and the renderers that answer requests. They are left, right, and the anchored
/// answer, if a view needs it or wrong pixels are counted. For one thread.
class SceneRenderer {
  public:
    using TellOpening = std::function<void(OpenProgress progress)>;

    /// The device must outlive it. @param tell is called on the thread that renders, while a file is opened.
    SceneRenderer(const gpu::Device& device, TellOpening tell) : m_device(device), m_tell(std::move(tell)) {}

    /// Opens what the request names unless it is open, and renders it. base::InputError or base::RunError say
    /// what cannot be. Where it cannot be opened, the scene that was open stays.
    /// @param stop ends it between two pictures, with none: a picture of a slow scene takes seconds.
    RenderResult answer(const RenderRequest& request, const std::stop_token& stop);

  private:
    using Clock = std::chrono::steady_clock;
    struct OpenScene {
        ViewSettings settings; ///< that it was opened with, and the layers that it has now
        std::shared_ptr<const scene::OpenedScene> opened;
        std::shared_ptr<const Obstacles> obstacles;
        std::unique_ptr<scenes::MovingScene> moving; ///< null until something moves or changes its layer
        bool areObstaclesBent = true;                ///< as the meshes that are shown
        render::GpuScene onDevice;
    };
    /// A generated scene or a file.
    scene::OpenedScene openNamed(const ViewSettings& settings) const;
    void open(const ViewSettings& settings);
    /// Brings the materials of the open scene into the layers of the settings.
    void followLayers(const ViewSettings& settings);
    scenes::Deform deformer(const scene::SceneMotion& motion, const ViewSettings& settings) const;
    /// Brings the open scene to the request's frame, and its obstacles, as far as the request needs them.
    void move(const RenderRequest& request, platform::WorkerPool& workers);
    void dropRenderers();
    void clearFlips();
    SideResult renderSide(const RenderRequest& request, std::size_t side, const scene::Camera& camera);
    render::Frame renderReference(const RenderRequest& request, const scene::Camera& camera);
    std::optional<render::Frame> renderReferenceIfItFits(const RenderRequest& request,
                                                         const scene::Camera& camera);
    void paint(ViewKind view, std::size_t side, const render::Frame* reference, SideResult& result);
    SceneOnDevice set();

    const gpu::Device& m_device;
    TellOpening m_tell;
    std::unique_ptr<OpenScene> m_scene;
    std::array<SideRenderer, 2> m_sides;
    SideRenderer m_reference;
    std::array<FlipWindow, 2> m_flips;
    Clock::time_point m_start = Clock::now();
};

} // namespace cdr::viewer
