#pragma once

#include <cdr/render/frame.h>
#include <cdr/render/renderer.h>
#include <viewer/state/camera/obstacles.h>
#include <viewer/state/view_settings.h>
#include <viewer/state/worker_timeline.h>
#include <viewer/state/wrong_view.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

/// What the interface wants to see next.
struct RenderRequest {
    std::uint64_t serial = 0; ///< counts requests
    ViewSettings settings;
    PictureExtent extent;
    std::optional<scene::Camera> camera; ///< the scene's own first one without
    std::uint32_t frame = 0;             ///< at which a scene that moves is shown
    /// Frames that picking can read. Copying them costs several times what the picture costs.
    bool wantsSurfaces = true;
    bool countsWrong = false; ///< in views that do not, too; takes wantsSurfaces and a frame more
    /// The camera stays where it was. Fitted splits are then fitted to it alone. So the picture that rests on the
    /// screen is the one that the copied command line renders, whatever frames came before.
    bool isAtRest = false;
    bool isSteered = false; ///< a person moves the camera, which keeps away from what bends
};

/// One technique's answer.
struct SideResult {
    render::RenderOptions options;
    std::shared_ptr<const render::Frame> frame;
    std::shared_ptr<const image::ImageRgba8> picture; ///< what the view shows of it
    WorkerTimeline timeline;
    std::optional<WrongCount> wrong;       ///< of the wrong view, or where it was asked for
    std::optional<std::uint64_t> flipsNow; ///< of the flips view: since the frame before
    std::uint64_t flippedPixels = 0;       ///< and within the last second
};

/// Why a request was not answered with pictures.
struct RenderFailure {
    std::string message;      ///< one line
    std::exception_ptr error; ///< what the message says; null where the request was stopped
};

/// The answer to a request.
struct RenderResult {
    std::uint64_t serial = 0; ///< the request's
    std::string sceneName{};  ///< the open scene's, as requested
    ViewSettings settings{};  ///< the request's
    std::shared_ptr<const scene::OpenedScene> scene{};
    std::shared_ptr<const Obstacles> obstacles{}; ///< of that scene; lives no longer than it
    scene::Camera camera{};
    std::uint32_t frame = 0;           ///< the request's
    std::vector<SideResult> sides{};   ///< empty when it failed
    double compositeMs = 0.0;          ///< frames turned into what the view shows
    double frameMs = 0.0;              ///< from the request taken to the pictures made
    std::uint64_t freeDeviceBytes = 0; ///< of the device that renders
    std::optional<RenderFailure> failure{};
    std::exception_ptr fatal{}; ///< nothing more will come
};

} // namespace cdr::viewer
