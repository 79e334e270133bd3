#include <fmt/format.h>
#include <ranks/rank_watch.h>

#include <chrono>

namespace cdr::ranks {

namespace {

/// Between two looks at whether a rank has said how the run ends.
constexpr auto kLook = std::chrono::milliseconds(250);
/// That a launcher has to end the ranks that another one leaves behind. Not all launchers do.
constexpr auto kPatience = std::chrono::seconds(5);
/// Before a rank that is asked to end says so. A launcher also asks if another rank was killed, and then that is reported.
constexpr auto kBefore = std::chrono::milliseconds(200);

} // namespace

RankWatch::RankWatch(const std::vector<std::string>& names, std::size_t own, SharedLife& shared,
                     LifeLock* locks, const HeldSignals& signals, const Say& say) noexcept
    : m_name(names[own]),
      m_nextName(names[(own + 1) % names.size()]),
      m_shared(shared),
      m_own(locks[own]),
      m_crashes(m_own),
      m_next(locks[(own + 1) % names.size()]),
      m_signals(signals),
      m_say(say) {
    if (names.size() > 1) {
        m_watchesNext = std::jthread([this] { watchNext(); });
    }
    m_watchesSignals = std::jthread([this] { watchSignals(); });
}

RankWatch::~RankWatch() {
    m_isOver = true;
    m_own.letGo();
    m_signals.wake(m_watchesSignals);
}

void RankWatch::append(const std::string& text) {
    const std::lock_guard lock(m_mutex);
    m_appended = text;
}

void RankWatch::watchNext() {
    if (m_next.waitForEnd()) {
        const int crash = m_next.crash();
        sayOnce(m_nextName + (crash == 0 ? " was killed" : fmt::format(" crashed ({})", nameOfCrash(crash))));
    }
}

void RankWatch::watchSignals() {
    auto left = std::chrono::duration_cast<std::chrono::milliseconds>(kPatience);
    while (left.count() > 0) {
        const int signal = m_signals.wait(kLook);
        if (m_isOver) {
            return;
        }
        if (signal != 0) {
            std::this_thread::sleep_for(kBefore);
            sayOnce(fmt::format("{} was asked to end by {}", m_name, nameOfSignal(signal)));
            endBySignal(signal);
        }
        if (m_shared.isSaid != 0) {
            left -= kLook;
        }
    }
    endBySignal(0);
}

void RankWatch::sayOnce(const std::string& line) {
    const std::lock_guard lock(m_mutex); // of this rank: its other thread may print
    if (m_shared.isSaid.exchange(1) == 0) {
        m_say(line + m_appended);
    }
}

} // namespace cdr::ranks
