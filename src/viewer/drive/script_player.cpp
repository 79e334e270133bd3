#include "script_player.h"

#include <cdr/base/error.h>
#include <viewer/session/overloaded.h>
#include <viewer/session/shown_picture.h>

#include <fmt/format.h>

#include <chrono>

namespace cdr::viewer {

namespace {

constexpr std::chrono::seconds kLongestWait{120};

} // namespace

ItemPlaces::Place ScriptPlayer::placeOf(const std::string& name, const ItemPlaces& places) {
    const auto place = places.find(name);
    if (!place) {
        throw base::RunError(fmt::format("script: no item '{}' is shown", name));
    }
    return *place;
}

void ScriptPlayer::clickItem(const std::string& name, const ItemPlaces& places) {
    const ItemPlaces::Place place = placeOf(name, places);
    m_steps.push_front(WaitUi{2}); // for what the click opens to be drawn
    m_steps.push_front(InputEvent(ButtonInput{.button = 0, .pressed = false}));
    m_steps.push_front(InputEvent(ButtonInput{.button = 0, .pressed = true}));
    m_steps.push_front(WaitUi{1}); // for the item to notice the pointer
    m_steps.push_front(InputEvent(MoveInput{place.x, place.y}));
}

bool ScriptPlayer::keepWaiting() {
    const auto now = std::chrono::steady_clock::now();
    if (!m_waitBegan) {
        m_waitBegan = now;
    } else if (now - *m_waitBegan > kLongestWait) {
        throw base::RunError("script: what was waited for does not come");
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
    if (!m_resultsWanted || session.results() < *m_resultsWanted) {
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

ScriptWish ScriptPlayer::step(Window& window, const ItemPlaces& places, const Session& session,
                              const ViewerModel& model) {
    ScriptWish wish;
    if (m_steps.empty() || waits(session, model)) {
        return wish;
    }
    const ScriptStep step = m_steps.front();
    m_steps.pop_front();
    std::visit(Overloaded{[&](const InputEvent& event) { window.inject(event); },
                          [&](const ClickItem& click) { clickItem(click.name, places); },
                          [&](const WindowSize& size) { window.resize(size.width, size.height); },
                          [&](const SaveWindow& save) { wish.window = save.file; },
                          [&](const SavePicture& save) { wish.picture = save.file; },
                          [&](const PrintPlace& print) {
                              const ItemPlaces::Place place = placeOf(print.name, places);
                              wish.text = fmt::format("{} {:.0f} {:.0f}", print.name, place.x, place.y);
                          },
                          [&](const PrintState&) { wish.text = stateLine(model); },
                          [&](const PrintCommand&) { wish.text = commandLinesOf(model); },
                          [&](const Minimise&) {
                              window.minimise();
                              window.inject(ResizeInput{0, 0}); // what other systems say of it
                          },
                          [&](const Restore&) {
                              window.restore();
                              window.inject(window.currentSize());
                          },
                          [&](const Quit&) { wish.quits = true; }, [](const auto&) {}},
               step);
    return wish;
}

} // namespace cdr::viewer
