#include "frame_maker.h"

#include <experiments/certified_frame.h>

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace cdr::cli {

FrameMaker::FrameMaker(const gpu::Device& device, const scene::Scene& scene, scenes::MovingScene* moving,
                       const render::RenderOptions& options, const WantedOfFrames& wanted,
                       host::WorkerPool& workers)
    : m_options(options),
      m_subPixelBits(device.info().subPixelBits),
      m_workers(workers),
      m_moving(moving),
      m_onDevice(moving != nullptr ? render::GpuScene(device, moving->world())
                                   : render::GpuScene(device, scene)),
      m_renderer(moving != nullptr ? render::Renderer(device, m_onDevice, options)
                                   : render::Renderer(device, scene, m_onDevice, options)) {
    if (wanted.truth) {
        m_caster.emplace(scene, workers);
    }
    if (wanted.certificate) {
        m_certifier.emplace(scene, workers);
    }
}

void FrameMaker::skip(std::uint32_t number, const scene::Camera& camera) {
    show(number);
    m_renderer.skip(camera);
}

render::Frame FrameMaker::draw(std::uint32_t number, const scene::Camera& camera) {
    show(number);
    if (m_options.trace != nullptr) {
        m_options.trace->beginFrame(fmt::format("frame {}", number));
    }
    return m_renderer.render(camera);
}

FrameOutput FrameMaker::finish(std::uint32_t number, render::Frame frame) {
    std::optional<CertifiedOutput> certified;
    if (m_certifier) {
        certified = certify(frame);
    }
    std::optional<measure::TruthImage> truth;
    if (m_caster) {
        truth = m_caster->cast(frame.camera, m_options.width, m_options.height, m_workers);
    }
    return {number, std::move(frame), std::move(truth), std::move(certified)};
}

CertifiedOutput FrameMaker::certify(render::Frame& frame) {
    const auto begin = std::chrono::steady_clock::now();
    const measure::DrawnFrame drawn = experiments::drawnFrame(frame, m_options, m_subPixelBits);
    CertifiedOutput made{.certificate = m_certifier->certify(drawn, m_workers),
                         .snapPixels = drawn.snapPixels};
    experiments::putRight(frame, made.certificate);
    made.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return made;
}

void FrameMaker::show(std::uint32_t number) {
    if (m_moving == nullptr || !m_moving->show(number, m_workers)) {
        return;
    }
    if (m_caster) {
        m_caster->follow(m_moving->deformedMeshes(), m_workers);
    }
    if (m_certifier) {
        m_certifier->follow(m_moving->deformedMeshes(), m_workers);
    }
}

} // namespace cdr::cli
