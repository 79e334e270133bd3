#pragma once

#include "script.h"

#include <viewer/session/player.h>

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

/// Plays a script, a step per frame of the interface.
class ScriptPlayer : public Player {
  public:
    explicit ScriptPlayer(std::vector<ScriptStep> steps) : m_steps(steps.begin(), steps.end()) {}

    /// Plays the step that is due. base::RunError for an item that is not there, or a frame that does not come.
    PlayerState step(const PlayedViewer& viewer) override;

  private:
    void play(const ScriptStep& step, const PlayedViewer& viewer);
    bool waits(const Session& session, const ViewerModel& model);
    bool waitsForFrame(const WaitFrame& frame, const Session& session);
    /// Begins or goes on waiting; base::RunError when it has taken too long.
    bool keepWaiting();
    void clickItem(const ClickItem& click, ItemPlaces& places);
    static ItemPlaces::Place placeOf(const std::string& name, const ItemPlaces& places);

    std::deque<ScriptStep> m_steps;
    PlayerState m_state = PlayerState::plays;
    std::optional<std::uint64_t> m_resultsWanted;
    std::optional<std::chrono::steady_clock::time_point> m_waitBegan;
};

} // namespace cdr::viewer
