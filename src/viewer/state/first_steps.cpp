#include "first_steps.h"

#include <array>

namespace cdr::viewer {

void FirstSteps::see(const ViewSettings& settings, const scene::Camera& camera) {
    if (m_step >= kSteps) {
        return;
    }
    const bool isSameScene = m_settings && m_settings->scene == settings.scene;
    const std::array<bool, kSteps> done{isSameScene && m_settings->divider != settings.divider,
                                        isSameScene && m_camera != scene::Camera{} && m_camera != camera,
                                        isSameScene && m_settings->view != settings.view};
    m_step += done.at(static_cast<std::size_t>(m_step)) ? 1 : 0;
    m_settings = settings;
    m_camera = camera;
}

std::optional<std::string_view> FirstSteps::text() const {
    static constexpr std::array<std::string_view, kSteps> kTexts{
        "1 of 3: drag the white line, and see the same scene under two techniques. Esc skips this.",
        "2 of 3: drag with the middle button to go round what you see, and turn the wheel to come nearer.",
        "3 of 3: press V until the wrong pixels are red. F1 lists all keys, T shows a tour.",
    };
    return m_step < kSteps ? std::optional(kTexts.at(static_cast<std::size_t>(m_step))) : std::nullopt;
}

} // namespace cdr::viewer
