#include "script_player.h"

#include "state_line.h"

#include <cdr/base/format_error.h>
#include <cdr/image/codec.h>
#include <cdr/platform/standard_streams.h>
#include <viewer/state/overloaded.h>
#include <viewer/state/shown_picture.h>

#include <fmt/format.h>

#include <chrono>

namespace cdr::viewer {

namespace {

/// Far longer than any frame takes on a busy machine. It only ends a script that waits for what never comes.
constexpr std::chrono::seconds kLongestWait{1200};

void savePicture(const std::filesystem::path& file, const ViewerModel& model) {
    const image::ImageRgba8 picture = shownPicture(model.picture.shown.get(), model.settings.divider);
    if (!picture.pixels.empty()) {
        image::writeImage(file, picture);
    }
}

} // namespace

ItemPlaces::Place ScriptPlayer::placeOf(const std::string& name, const ItemPlaces& places) {
    const auto place = places.find(name);
    if (!place) {
        throw base::runError("script: no item '{}' is shown", name);
    }
    return *place;
}

void ScriptPlayer::clickItem(const ClickItem& click, ItemPlaces& places) {
    const ItemPlaces::Place place = placeOf(click.name, places);
    if (!place.isInView && !click.isRevealed) {
        places.reveal(click.name);
        m_steps.push_front(ClickItem{.name = click.name, .isRevealed = true});
        m_steps.push_front(WaitUi{2}); // for the panel to scroll, and to be drawn so
        return;
    }
    if (!place.isInView) {
        throw base::runError("script: the item '{}' cannot be scrolled into view", click.name);
    }
    m_steps.push_front(WaitUi{2}); // for what the click opens to be drawn
    m_steps.push_front(Tap{});
    m_steps.push_front(WaitUi{1}); // for the item to notice the pointer
    m_steps.push_front(InputEvent(MoveInput{place.x, place.y}));
}

bool ScriptPlayer::keepWaiting() {
    const auto now = std::chrono::steady_clock::now();
    if (!m_waitBegan) {
        m_waitBegan = now;
    } else if (now - *m_waitBegan > kLongestWait) {
        throw base::RunError("script: what the script waits for does not happen");
    }
    return true;
}

bool ScriptPlayer::waitsForFrame(const WaitFrame& frame, const Session& session) {
    if (!m_waitBegan) {
        return keepWaiting(); // for what was asked for just now to be asked of the renderer
    }
    if (!m_resultsWanted && (frame.more > 0 || session.isSettled())) {
        m_resultsWanted = session.results() + frame.more;
    }
    const bool isThere = m_resultsWanted && session.results() >= *m_resultsWanted;
    if (!isThere && !session.isIdle()) {
        return keepWaiting();
    }
    m_resultsWanted.reset();
    return false;
}

bool ScriptPlayer::waits(const Session& session, const ViewerModel& model) {
    bool isWaiting = false;
    if (auto* ui = std::get_if<WaitUi>(&m_steps.front())) {
        return ui->frames-- > 0;
    }
    if (const auto* state = std::get_if<WaitState>(&m_steps.front())) {
        isWaiting = stateLine(model).find(state->text) == std::string::npos && keepWaiting();
    } else if (const auto* frame = std::get_if<WaitFrame>(&m_steps.front())) {
        isWaiting = waitsForFrame(*frame, session);
    }
    if (!isWaiting) {
        m_waitBegan.reset();
    }
    return isWaiting;
}

void ScriptPlayer::play(const ScriptStep& step, const PlayedViewer& viewer) {
    Window& window = viewer.window;
    const auto printLine = [](const std::string& line) { platform::printNow(line + "\n"); };
    std::visit(Overloaded{[&](const InputEvent& event) { window.inject(event); },
                          [&](const ClickItem& click) { clickItem(click, viewer.places); },
                          [&](const Tap&) {
                              window.inject(ButtonInput{.button = 0, .pressed = true});
                              window.inject(ButtonInput{.button = 0, .pressed = false});
                          },
                          [&](const WindowSize& size) { window.resize(size.width, size.height); },
                          [&](const SaveWindow& save) { viewer.capture = save.file; },
                          [&](const SavePicture& save) { savePicture(save.file, viewer.model); },
                          [&](const PrintPlace& print) {
                              const ItemPlaces::Place place = placeOf(print.name, viewer.places);
                              printLine(fmt::format("{} {:.0f} {:.0f}", print.name, place.x, place.y));
                          },
                          [&](const PrintState&) { printLine(stateLine(viewer.model)); },
                          [&](const PrintCommand&) { printLine(commandLinesOf(viewer.model.picture)); },
                          [&](const Minimise&) {
                              window.minimise();
                              window.inject(ResizeInput{0, 0}); // as other window systems report it
                          },
                          [&](const Restore&) {
                              window.restore();
                              window.inject(window.currentSize());
                          },
                          [&](const Quit&) { m_state = PlayerState::quits; }, [](const auto&) {}},
               step);
}

PlayerState ScriptPlayer::step(const PlayedViewer& viewer) {
    if (!m_steps.empty()) {
        if (waits(viewer.session, viewer.model)) {
            const bool isForPicture = std::holds_alternative<WaitFrame>(m_steps.front());
            return isForPicture ? PlayerState::waits : m_state;
        }
        const ScriptStep step = m_steps.front();
        m_steps.pop_front();
        play(step, viewer);
    }
    const bool hasEnded = m_steps.empty() && m_state == PlayerState::plays;
    return hasEnded ? PlayerState::hasEnded : m_state;
}

} // namespace cdr::viewer
