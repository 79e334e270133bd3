#include "render_thread.h"

#include "render_failure.h"
#include "scene_renderer.h"

#include <exception>
#include <memory>
#include <utility>

namespace cdr::viewer {

namespace {

/// The renderer's answer, or why there is none. What the next request cannot mend passes through.
RenderResult answerOrExplain(SceneRenderer& renderer, const RenderRequest& request,
                             const std::stop_token& stop) {
    RenderFailure failure;
    try {
        return renderer.answer(request, stop);
    } catch (...) {
        failure = explainFailure();
    }
    // On the heap: GCC 12 takes part of one on the stack for uninitialised.
    const auto result = std::make_unique<RenderResult>();
    result->serial = request.serial;
    result->settings = request.settings;
    result->failure = std::move(failure);
    return std::move(*result);
}

} // namespace

RenderThread::RenderThread(const gpu::Device& device, std::function<void()> notify)
    : m_notify(std::move(notify)),
      m_thread([this, &device](const std::stop_token& stop) { serve(stop, device); }) {}

void RenderThread::serve(const std::stop_token& stop, const gpu::Device& device) {
    try {
        SceneRenderer renderer(device, [this](OpenProgress progress) {
            m_opening.put(std::move(progress));
            m_notify();
        });
        while (const auto request = m_requests.wait(stop)) {
            m_notify();
            m_results.put(answerOrExplain(renderer, *request, stop));
            m_notify();
        }
    } catch (...) {
        const auto last = std::make_unique<RenderResult>();
        last->fatal = std::current_exception();
        m_results.put(std::move(*last));
        m_notify();
    }
}

} // namespace cdr::viewer
