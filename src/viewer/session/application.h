#pragma once

#include "arguments.h"
#include "camera_control.h"
#include "player.h"
#include "render_device.h"
#include "session.h"

#include <viewer/panels/interface.h>
#include <viewer/panels/item_places.h>
#include <viewer/panels/widgets.h>
#include <viewer/state/model/viewer_model.h>
#include <viewer/window/presenter.h>
#include <viewer/window/ui_device.h>
#include <viewer/window/window.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace cdr::viewer {

/// The program: a window whose thread runs the interface, and a thread that renders.
class Application {
  public:
    /// base::InputError for what cannot be asked for, base::RunError where there is no window system.
    /// @param player plays input if not null; must outlive the application.
    explicit Application(const Arguments& arguments, Player* player = nullptr);
    /// Until the window closes. base::RunError after a failure that no other request can correct.
    void run();
    /// What validation says of both devices, as long as they live and when they go.
    std::array<std::shared_ptr<const gpu::ValidationLog>, 2> validationLogs() const {
        return {m_renderInstance.validationLog(), m_ui.instance().validationLog()};
    }

  private:
    using Clock = std::chrono::steady_clock;
    bool goesOn() const;
    /// Whether there is nothing to do but for the renderer, which wakes this.
    bool waitsForPicture() const { return m_player != nullptr && m_playerWaits && !m_session.isSettled(); }
    void wait() const;
    void stepPlayer();
    double secondsOfUpdate();
    void handleInput();
    /// @return who has the key. Panels that do not fit beside the picture get none.
    InputOwner handleKey(const KeyInput& key);
    /// An action that fails, such as writing into a folder, shows a message and has no other effect.
    void perform(Action action);
    void tryPerform(Action action);
    void dropFiles(const DropInput& drop);
    /// A path that could not be saved is kept, and saved instead of a new one begun.
    void toggleRecording();
    /// From its beginning, if there is one. Says so if it is another scene's.
    void playRecording();
    void toggleVideo();
    void recordVideo(double seconds);
    void copyCommandLines();
    void captureWindow();
    void frameSelected();
    void toggleTour();
    void goHome();
    PictureArea pictureArea() const;
    float sidebarWidth() const;
    /// Whether the window changes without input, or has to count its frames.
    bool isMoving() const;
    bool isRedrawDue() const;
    void drawFrame();
    void layOut();
    void present(image::ImageRgba8* capture, ImDrawData* drawn);
    /// The same, with the window into the file that was asked for. Where that fails, the interface says why.
    void presentAndSave(ImDrawData* drawn);
    void savePicture(const std::filesystem::path& file);
    void saveScreenshot();
    /// What run() does until the window closes.
    void serve();
    /// Saves what is still to be saved, but no screenshot after a failure. A failed save does not prevent the others; the
    /// first failure is thrown at the end.
    /// @param failure that came before; null: none.
    void finish(std::exception_ptr failure);

    Arguments m_arguments;
    ViewerModel m_model;
    Player* m_player; ///< null once it has ended, or when a person is in charge
    WindowSystem m_system;
    gpu::Instance m_renderInstance;
    RenderDevice m_renderDevice; ///< before the window, since a device that is not there needs none
    Window m_window;
    UiDevice m_ui;
    Presenter m_presenter;
    Interface m_interface;
    ItemPlaces m_places;
    Widgets m_widgets{m_places};
    CameraControl m_control;
    /// Last, so that its thread ends first: the loader (1.3.239) reads freed memory when an instance goes
    /// while another's device is used.
    Session m_session;

    std::optional<std::filesystem::path> m_capture; ///< file for the next frame's window
    std::optional<std::string> m_unsaved;           ///< why the last window was not saved
    Clock::time_point m_lastFrame = Clock::now();
    Clock::time_point m_lastUpdate = Clock::now();
    int m_redraws = 3; ///< frames due: the interface takes a few to settle after input
    std::uint64_t m_uiFrames = 0;
    std::vector<double> m_uiIntervals; ///< milliseconds, for --statistics
    bool m_isMissed = false;           ///< the last frame does not show, so another is due
    bool m_playerWaits = false;        ///< for a picture
    bool m_quits = false;
};

} // namespace cdr::viewer
