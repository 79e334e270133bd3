#pragma once

#include "camera_control.h"
#include "render_device.h"
#include "render_thread.h"

#include <viewer/state/model/viewer_model.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

namespace cdr::viewer {

/// What the window has for a session since the last update.
struct SessionInput {
    PictureArea area;
    glm::dvec2 cursor{0.0};
    double seconds = 0.0;   ///< since then
    bool isSteered = false; ///< somebody moves the camera by hand
    bool isDragged = false; ///< a button is held that moves it with the pointer
};

/// Requests from the render thread the pictures that the model needs, and gives the results to the model.
class Session {
  public:
    /// The device and the model must outlive the session.
    Session(RenderDevice& device, ViewerModel& model);

    /// Renders all that is wanted again, on a new device.
    void renewDevice();

    /// Moves the camera along its path, if it follows one, and asks for what is wanted and not yet asked for.
    void update(const SessionInput& input);
    /// Says how much of a file is opened. True when that is new.
    bool takeOpening();
    /// Takes the newest result into the model. True when there are new pictures. Rethrows what the first
    /// scene failed for, and what ended the render thread.
    bool takeResult();
    /// After the camera was put elsewhere: its pivot and its speed follow from what the next picture shows.
    void aimAnew();
    /// Picks what the picture shown now has at a pixel, however the camera moves on. Where its surfaces were
    /// not copied it is rendered once more. Nothing while nothing is shown.
    void click(const glm::dvec2& pixel);

    /// Whether all that is wanted is shown.
    bool isSettled() const { return m_asked && m_shownSerial == m_asked->serial && !m_click; }
    /// Whether nothing changes: all that is wanted is shown, nothing moves, and no picture is asked for by itself.
    bool isIdle() const { return m_isIdle && isSettled(); }
    /// Whether the render thread has taken the last request.
    bool isReady() const { return m_thread->isReady(); }
    std::uint64_t results() const { return m_results; }

  private:
    using Clock = std::chrono::steady_clock;
    struct Click {
        glm::dvec2 share; ///< of the picture's width and height
        double divider;   ///< at the time
        std::shared_ptr<const RenderResult> shown;
        std::optional<std::uint64_t> serial; ///< of the request that renders it once more
    };
    void startThread();
    void followPath(double seconds);
    void followTour();
    void followAnimation(double seconds);
    /// Adds the camera to what is recorded, if anything is.
    void recordCamera(double seconds);
    /// Whether an animation moves the scene's own camera, so that the frames of its path are moments of it.
    bool isAnimated() const;
    void playAnimation();
    /// Puts the camera where the scene's own is at a frame. Where it cannot, says why and ends what moves it.
    void goTo(std::uint32_t frame);
    /// At which a scene that moves is shown.
    std::uint32_t frameOfMotion() const;
    RenderRequest wantedRequest(const PictureArea& area) const;
    void ask(RenderRequest request);
    void adopt(RenderResult result);
    void takeWrong(const RenderResult& result);
    /// Forgets what is of how the scene was opened before, and nothing that a person sees as the scene's.
    void takeOpened(const RenderResult& result);
    /// Puts the camera into another scene, where nothing is picked yet.
    void enterScene(const RenderResult& result);
    /// Forgets how far it was to what the camera looked at, until a picture from `serial` on tells.
    void aimFrom(std::uint64_t serial);
    void pickOrAsk();
    void takeClicked(const RenderResult& result);
    void pick(const Click& click, const RenderResult& result);
    void readCursor(const PictureArea& area, const glm::dvec2& cursor);
    void count(const RenderResult& result);

    RenderDevice& m_device;
    ViewerModel& m_model;
    std::optional<RenderRequest> m_asked;
    ViewSettings m_good; ///< of the last request that did not fail
    std::uint64_t m_serial = 0;
    std::uint64_t m_shownSerial = 0;
    std::uint64_t m_results = 0;
    bool m_isIdle = false; ///< at the last update()
    /// The pictures from this one on can tell how far what the camera looks at is, and none has yet. Earlier ones show another
    /// place.
    std::optional<std::uint64_t> m_pivotFrom;
    std::optional<Click> m_click;
    Clock::time_point m_surfacesAsked{};
    struct Asked {
        std::uint64_t serial;
        Clock::time_point at;
    };
    std::deque<Asked> m_pending;              ///< asked for and not yet shown, oldest first
    std::deque<Clock::time_point> m_arrivals; ///< of the last second
    std::optional<RenderThread> m_thread;     ///< always there but in renewDevice()
};

} // namespace cdr::viewer
