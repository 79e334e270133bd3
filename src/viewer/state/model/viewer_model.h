#pragma once

#include "camera_model.h"
#include "interface_model.h"
#include "performance_model.h"
#include "picture_model.h"

#include <viewer/state/video_recording.h>
#include <viewer/state/view_settings.h>

#include <cstdint>
#include <memory>
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

/// All that the interface knows: one thread's. A function takes the part that it needs.
struct ViewerModel {
    ViewSettings settings; ///< that are wanted
    CameraModel camera;
    PictureModel picture;
    PerformanceModel performance;
    InterfaceModel interface;
    std::unique_ptr<VideoRecording> video; ///< null while none is recorded
    std::vector<Action> actions;           ///< to be done before the next frame
};

} // namespace cdr::viewer
