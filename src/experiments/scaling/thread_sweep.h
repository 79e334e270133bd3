#pragma once

#include "scaling.h"

#include <cdr/render/renderer.h>
#include <cdr/scene/scene_setup.h>

#include <runs/interleaved_frames.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cdr::experiments {

/// One (targets, submission, cascades, draws) over every number of threads.
class ThreadSweep {
  public:
    /// @param threads ascending from 1.
    /// @param common what all points share.
    ThreadSweep(const gpu::Device& device, const ScalingOptions& options, const scene::SceneSetup& setup,
                const render::GpuScene& gpuScene, std::vector<std::size_t> threads, ScalingPoint common);

    /// Renders and hashes one frame of each number of threads, which also warms them up. Once, and first.
    void hash(const std::function<void()>& step);
    /// Times one frame of each number of threads, in an order that is shuffled again for each repeat.
    void repeat(const std::function<void()>& step);

    /// In the order of the threads; after at least one repeat.
    std::vector<ScalingPoint> points() const;

  private:
    std::vector<std::size_t> m_cpus; ///< to pin the caller to the first of; empty to leave it free
    scene::Camera m_camera;
    std::vector<std::size_t> m_threads;
    ScalingPoint m_common;
    std::vector<std::unique_ptr<render::Renderer>> m_renderers; ///< by number of threads, as the next two
    runs::InterleavedFrames m_frames;
    std::vector<std::string> m_hashes;
};

} // namespace cdr::experiments
