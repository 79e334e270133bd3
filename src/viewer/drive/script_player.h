#pragma once

#include "script.h"

#include <viewer/panels/item_places.h>
#include <viewer/session/session.h>
#include <viewer/window/window.h>

#include <deque>
#include <filesystem>
#include <optional>
#include <string>

namespace cdr::viewer {

/// What a script wants of the program besides input.
struct ScriptWish {
    std::optional<std::filesystem::path> window;  ///< to be captured into
    std::optional<std::filesystem::path> picture; ///< to be written to
    std::string text;                             ///< to be printed
    bool quits = false;
};

/// Plays a script, a step per frame of the interface.
class ScriptPlayer {
  public:
    explicit ScriptPlayer(std::vector<ScriptStep> steps) : m_steps(steps.begin(), steps.end()) {}

    bool isDone() const { return m_steps.empty(); }
    /// Plays what is due. base::RunError for an item that is not there, or a frame that does not come.
    ScriptWish step(Window& window, const ItemPlaces& places, const Session& session,
                    const ViewerModel& model);

  private:
    bool waits(const Session& session, const ViewerModel& model);
    bool waitsForFrame(const WaitFrame& frame, const Session& session);
    /// Begins or goes on waiting; base::RunError when it has taken too long.
    bool keepWaiting();
    void clickItem(const std::string& name, const ItemPlaces& places);
    static ItemPlaces::Place placeOf(const std::string& name, const ItemPlaces& places);

    std::deque<ScriptStep> m_steps;
    std::optional<std::uint64_t> m_resultsWanted;
    std::optional<std::chrono::steady_clock::time_point> m_waitBegan;
};

} // namespace cdr::viewer
