#pragma once

#include "mailbox.h"

#include <cdr/gpu/device.h>
#include <viewer/state/requests/open_progress.h>
#include <viewer/state/requests/render_request.h>

#include <functional>
#include <optional>
#include <thread>

namespace cdr::viewer {

/// Renders on a thread of its own: takes the newest request, puts the newest result.
class RenderThread {
  public:
    /// @param device that renders; this thread alone uses it.
    /// @param notify is called, on this thread, whenever a request was taken, a result put, or more of a
    /// file opened.
    RenderThread(const gpu::Device& device, std::function<void()> notify);

    /// Replaces a request that was not yet taken.
    void request(RenderRequest request) { m_requests.put(std::move(request)); }
    /// Whether the last request was taken, so that the next would replace nothing.
    bool isReady() const { return m_requests.isEmpty(); }
    /// The newest result that was not yet taken.
    std::optional<RenderResult> take() { return m_results.take(); }
    /// How much of a file it has opened, where that grew.
    std::optional<OpenProgress> takeOpening() { return m_opening.take(); }

  private:
    void serve(const std::stop_token& stop, const gpu::Device& device);

    std::function<void()> m_notify;
    Mailbox<RenderRequest> m_requests;
    Mailbox<RenderResult> m_results;
    Mailbox<OpenProgress> m_opening;
    std::jthread m_thread; ///< last, so that it ends first
};

} // namespace cdr::viewer
