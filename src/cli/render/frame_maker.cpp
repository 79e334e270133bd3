#include "frame_maker.h"

#include <cdr/image/beside.h>
#include <cdr/platform/stopwatch.h>

#include <fmt/format.h>
#include <output/certified_frame.h>

#include <utility>
#include <vector>

namespace cdr::cli {

FrameMaker::FrameMaker(const gpu::Device& device, const scene::Scene& scene, scenes::MovingScene* moving,
                       const render::RenderOptions& options, const options::ViewsPlan& views,
                       const WantedOfFrames& wanted, platform::WorkerPool& workers)
    : m_options(options),
      m_plan(views),
      m_subPixelBits(device.info().subPixelBits),
      m_workers(workers),
      m_moving(moving),
      m_onDevice(moving != nullptr ? render::GpuScene(device, moving->world())
                                   : render::GpuScene(device, scene)),
      m_drawer(device, scene, m_onDevice, options, views.count()) {
    if (wanted.truth) {
        m_caster.emplace(scene, workers);
    }
    if (wanted.certificate) {
        m_certifier.emplace(scene, workers);
    }
}

void FrameMaker::skip(std::uint32_t number, const scene::Camera& camera) {
    show(number);
    m_drawer.skip(m_plan, camera);
}

render::Frame FrameMaker::draw(std::uint32_t number, const scene::Camera& camera) {
    show(number);
    if (m_options.trace != nullptr) {
        m_options.trace->beginFrame(fmt::format("frame {}", number));
    }
    render::Frame frame = m_drawer.render(m_plan, camera);
    if (m_plan.isAnaglyph()) {
        frame.color = image::anaglyphOf(frame.color);
    }
    return frame;
}

FrameOutput FrameMaker::finish(std::uint32_t number, render::Frame frame) {
    std::optional<CertifiedOutput> certified;
    if (m_certifier) {
        certified = certify(frame);
    }
    std::optional<measure::TruthImage> truth;
    if (m_caster) {
        truth = castAll(frame.camera);
    }
    return {number, std::move(frame), std::move(truth), std::move(certified)};
}

measure::TruthImage FrameMaker::castAll(const scene::Camera& camera) const {
    std::vector<measure::TruthImage> truths;
    for (const scene::Camera& view : m_plan.camerasOf(camera)) {
        truths.push_back(m_caster->cast(view, m_options.width, m_options.height, m_workers));
    }
    return m_plan.join(truths, camera);
}

CertifiedOutput FrameMaker::certify(render::Frame& frame) {
    const platform::Stopwatch watch;
    const measure::DrawnFrame drawn = output::drawnFrame(frame, m_options, m_subPixelBits);
    CertifiedOutput made{.certificate = m_certifier->certify(drawn, m_workers),
                         .snapPixels = drawn.snapPixels};
    output::putRight(frame, made.certificate);
    made.milliseconds = watch.milliseconds();
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
