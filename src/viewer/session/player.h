#pragma once

#include "session.h"

#include <viewer/panels/item_places.h>
#include <viewer/state/model/viewer_model.h>
#include <viewer/state/picture_area.h>
#include <viewer/window/window.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace cdr::viewer {

/// The parts of the running viewer that a player may use.
struct PlayedViewer {
    Window& window;
    Session& session;
    ViewerModel& model;
    ItemPlaces& places;
    PictureArea area;
    std::optional<std::filesystem::path>& capture; ///< file that receives the window's pixels, next frame
};

enum class PlayerState : std::uint8_t {
    plays,
    waits,    ///< for a picture, so that the interface need not be drawn more often than for a person
    hasEnded, ///< the viewer goes on without it
    quits,    ///< the viewer ends
};

/// Plays input instead of a person, one step before each frame of the interface.
class Player {
  public:
    /// How long each frame lasts for whatever moves, seconds. Fixed, so that a slow machine moves things no further.
    static constexpr double kStepSeconds = 1.0 / 60.0;

    virtual ~Player() = default;
    virtual PlayerState step(const PlayedViewer& viewer) = 0;
};

} // namespace cdr::viewer
