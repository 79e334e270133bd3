#pragma once

#include "animation/playback.h"
#include "camera/orbit_controller.h"
#include "camera/path_recorder.h"
#include "first_steps.h"
#include "frame_statistics.h"
#include "picking.h"
#include "requests/render_request.h"
#include "video_recording.h"
#include "view_settings.h"

#include <experiments/camera_options.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

/// What a key, a button or a script asks the program to do once.
enum class Action : std::uint8_t {
    quit,
    screenshotPicture, ///< the picture as shown, divider included
    screenshotWindow,
    copyCommandLine,
    sceneCamera, ///< back to the scene's own
    record,      ///< begins or ends recording the camera
    playRecording,
    forgetMeasuring,
    frameSelected, ///< look at what was clicked last so that it fills the picture
    tour,          ///< begins or ends it
    video,         ///< begins or ends recording what is shown
};

/// Where the camera comes from.
enum class Motion : std::uint8_t { free, scenePath, recording, tour };

/// The panels beside the picture, as their tabs name them.
inline constexpr std::array<const char*, 5> kPanels{"Look", "Camera", "Draw", "Frame", "Inside"};

/// The panel whose controls the keyboard reaches, instead of the camera.
struct PanelKeys {
    std::size_t panel = 0; ///< of kPanels
    bool isOpened = false; ///< whether it has come to the front
};

/// A line for the person at the window, and until when it shows.
struct Notice {
    std::string text;
    bool isProblem = false;
    std::chrono::steady_clock::time_point until{};
};

/// All that the interface knows: one thread's.
struct ViewerModel {
    ViewSettings settings;
    std::string device;   ///< that renders, with its driver
    std::string uiDevice; ///< that shows

    // Camera
    scene::Camera camera;
    scene::Camera sceneCamera;                             ///< the scene's own at frame 0
    bool hasCamera = false;                                ///< false until a scene is open
    std::optional<experiments::CameraOptions> firstCamera; ///< of the command line, for the first scene
    bool orbits = false;
    glm::dvec3 pivot{0.0};
    double surfaceView = 0.0; ///< view distance of what is looked at: speeds follow from it
    Motion motion = Motion::free;
    std::uint32_t pathFrame = 0;
    PathRecorder recorder;
    double playedSeconds = 0.0;            ///< of what was recorded, or of the tour
    Playback playback;                     ///< of a file's animation
    std::unique_ptr<VideoRecording> video; ///< null while none is recorded

    // What is shown
    std::shared_ptr<const RenderResult> shown; ///< the last that did not fail
    /// By side: the newest frame that picking can read.
    std::array<std::shared_ptr<const render::Frame>, 2> readable;
    std::array<std::optional<PickedPoint>, 2> underCursor;
    std::vector<WrongCount> wrong; ///< by side, the last that were counted with these techniques
    bool isWrongCurrent = false;   ///< of the picture that is shown
    bool seesNothing = false;      ///< no surface is in view
    Measuring measuring;
    std::optional<scene::Camera> clickedCamera; ///< of the picture that was clicked on last
    FrameStatistics statistics;
    double framesPerSecond = 0.0;
    double lagSeconds =
        0.0; ///< how long ago the oldest picture was asked for that is not yet shown; 0 for none
    double uiFrameMs = 0.0;     ///< the interface, drawn and handed to the display
    double presentMs = 0.0;     ///< of it, waiting for and handing to the display
    bool rendersAlways = false; ///< though nothing changes: to see times settle

    // Interface
    base::LengthUnit unit = base::LengthUnit::automatic; ///< of lengths
    bool showsPanel = true;
    std::optional<PanelKeys> panelKeys;
    bool showsHelp = false;
    float hiddenHelp = 0.0f; ///< rows of the help that need scrolling, in the window's units
    FirstSteps firstSteps;
    Notice notice;
    std::vector<Action> actions; ///< to be done before the next frame

    void say(std::string text, bool isProblem = false) {
        constexpr std::chrono::seconds kShown{6};
        notice = {std::move(text), isProblem, std::chrono::steady_clock::now() + kShown};
    }
};

} // namespace cdr::viewer
