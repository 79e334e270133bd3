#include "application.h"

#include <cdr/base/error.h>
#include <cdr/image/codec.h>

#include <fmt/format.h>
#include <imgui.h>

namespace cdr::viewer {

Application::Application(const Arguments& arguments)
    : m_arguments(arguments),
      m_system(fmt::format("cdr render {} -o picture.png", arguments.scene)),
      m_renderInstance({.validate = arguments.validate, .extensions = {}}),
      m_renderDevice(m_renderInstance, arguments.device),
      m_window(m_system, 1280, 720, "cdr-viewer"),
      m_ui(m_system, m_window, arguments.device, arguments.validate),
      m_presenter(m_ui, m_window, arguments.waitsForDisplay),
      m_interface(m_ui, m_window, m_presenter, arguments.uiScale),
      m_renderThread(m_renderDevice, [] { WindowSystem::wake(); }) {
    m_request.scene = arguments.scene;
    m_request.sides.push_back({.technique = depth::parseTechnique(arguments.technique)});
    m_renderThread.request(m_request);
}

void Application::take(RenderResult result) {
    if (result.fatal) {
        std::rethrow_exception(result.fatal);
    }
    if (!result.message.empty()) {
        fmt::print(stderr, "{}\n", result.message);
    }
    for (std::size_t side = 0; side < result.sides.size(); ++side) {
        m_presenter.picture(side).set(result.sides[side].picture);
    }
    m_shown = std::make_shared<const RenderResult>(std::move(result));
}

void Application::drawFrame() {
    const Clock::time_point now = Clock::now();
    m_interface.begin(std::chrono::duration<double>(now - m_lastFrame).count());
    m_lastFrame = now;
    ImGui::Begin("Hello");
    ImGui::TextUnformatted(m_shown ? m_shown->sceneName.c_str() : "loading");
    ImGui::End();
    ImDrawData* drawn = m_interface.end();
    const bool isLast = m_arguments.frames && m_uiFrames + 1 >= *m_arguments.frames;
    image::ImageRgba8 capture;
    const bool captures = isLast && !m_arguments.screenshot.empty();
    m_presenter.draw({.area = {{0, 0}, m_window.extent()}, .divider = 1.0, .pictures = 1}, drawn,
                     captures ? &capture : nullptr);
    if (captures) {
        image::writeImage(m_arguments.screenshot, capture);
    }
    ++m_uiFrames;
}

void Application::run() {
    while (!m_window.isClosing() && !(m_arguments.frames && m_uiFrames >= *m_arguments.frames)) {
        m_window.wait(0.05);
        if (auto result = m_renderThread.take()) {
            take(std::move(*result));
        }
        drawFrame();
    }
    requireSilentValidation();
}

void Application::requireSilentValidation() const {
    for (const gpu::Instance* instance : {&m_renderInstance, &m_ui.instance()}) {
        const auto messages = instance->validation().messages();
        if (!messages.empty()) {
            throw base::RunError(
                fmt::format("{} validation messages, the first: {}", messages.size(), messages.front()));
        }
    }
}

} // namespace cdr::viewer
