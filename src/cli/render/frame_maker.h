#pragma once

#include "frame_output.h"

#include <cdr/gpu/device.h>
#include <cdr/measure/certify/certifier.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/renderer.h>
#include <scenes/moving_scene.h>

#include <options/views/views_drawer.h>
#include <options/views/views_plan.h>

#include <cstdint>
#include <optional>

namespace cdr::cli {

/// What a command needs of its frames beside what is drawn.
struct WantedOfFrames {
    bool truth = false;
    bool certificate = false;
};

/// Draws frame after frame of a scene, from one view or several at a time. Casts the truth of a frame or certifies it, if the
/// options ask for that.
class FrameMaker {
  public:
    /// @param moving the scene, where it moves; else null. What is given by reference must outlive the maker.
    FrameMaker(const gpu::Device& device, const scene::Scene& scene, scenes::MovingScene* moving,
               const render::RenderOptions& options, const options::ViewsPlan& views,
               const WantedOfFrames& wanted, platform::WorkerPool& workers);

    /// Goes past a frame that another rank makes.
    void skip(std::uint32_t number, const scene::Camera& camera);
    render::Frame draw(std::uint32_t number, const scene::Camera& camera);
    /// Of the frame that was drawn last.
    FrameOutput finish(std::uint32_t number, render::Frame frame);

  private:
    CertifiedOutput certify(render::Frame& frame); ///< and repairs it
    measure::TruthImage castAll(const scene::Camera& camera) const;
    void show(std::uint32_t number);

    const render::RenderOptions& m_options;
    const options::ViewsPlan& m_plan;
    std::uint32_t m_subPixelBits;
    platform::WorkerPool& m_workers;
    scenes::MovingScene* m_moving;
    render::GpuScene m_onDevice;
    options::ViewsDrawer m_drawer;
    std::optional<measure::TruthCaster> m_caster;
    std::optional<measure::Certifier> m_certifier;
};

} // namespace cdr::cli
