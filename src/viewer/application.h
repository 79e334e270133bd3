#pragma once

#include "arguments.h"
#include "interface.h"
#include "presenter.h"
#include "render_thread.h"
#include "ui_device.h"
#include "window.h"

#include <chrono>
#include <cstdint>

namespace cdr::viewer {

/// The program: a window whose thread runs the interface, and a thread that renders.
class Application {
  public:
    explicit Application(const Arguments& arguments);
    /// Until the window closes. base::RunError when something failed that no other request can mend.
    void run();

  private:
    using Clock = std::chrono::steady_clock;
    void take(RenderResult result);
    void drawFrame();
    void requireSilentValidation() const;

    Arguments m_arguments;
    WindowSystem m_system;
    gpu::Instance m_renderInstance;
    gpu::Device m_renderDevice;
    Window m_window;
    UiDevice m_ui;
    Presenter m_presenter;
    Interface m_interface;
    RenderThread m_renderThread;

    RenderRequest m_request;
    std::shared_ptr<const RenderResult> m_shown;
    Clock::time_point m_lastFrame = Clock::now();
    std::uint64_t m_uiFrames = 0;
};

} // namespace cdr::viewer
