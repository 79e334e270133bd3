#pragma once

#include "view_settings.h"

#include <cdr/scene/camera.h>

#include <optional>
#include <string_view>

namespace cdr::viewer {

/// Three steps for a person who starts the viewer for the first time. Each disappears when it is done.
class FirstSteps {
  public:
    void begin() { m_step = 0; }
    void end() { m_step = kSteps; }

    /// Checks whether the current step was done since the last call.
    void see(const ViewSettings& settings, const scene::Camera& camera);

    /// "1 of 3: ..."; nothing when all are done, or none was begun.
    std::optional<std::string_view> text() const;

  private:
    static constexpr int kSteps = 3;
    int m_step = kSteps;
    std::optional<ViewSettings> m_settings; ///< as they were
    scene::Camera m_camera;
};

} // namespace cdr::viewer
