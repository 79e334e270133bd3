#pragma once

#include <ranks/process_end.h>
#include <ranks/ranks.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace cdr::ranks {

/// Of a machine's ranks, in memory that they share. One of them makes it before the others look at it.
struct SharedLife {
    /// Whether one of the ranks has said how the run ends.
    std::atomic<std::uint32_t> isSaid{0};
    static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
};

/// Prints a message when a rank of this machine is killed or crashes, or when a signal ends this one. Launchers do not agree
/// on what they print then. Each rank watches the next one, and the last one the first. Only one rank of a machine prints how
/// the run ends. A rank that goes on for seconds after that ends too.
class RankWatch {
  public:
    /// @param names of the machine's ranks, in order. @param own the place of this one, which holds its lock.
    /// @param locks by rank. What is given by reference must outlive the watch. Like MPI itself it does not
    /// go on without memory or threads.
    RankWatch(const std::vector<std::string>& names, std::size_t own, SharedLife& shared, LifeLock* locks,
              const HeldSignals& signals, const Say& say) noexcept;
    /// By the thread that made it. Waits for the end of the watched rank's own watch.
    ~RankWatch();
    RankWatch(const RankWatch&) = delete;
    RankWatch& operator=(const RankWatch&) = delete;

    /// What the line ends with.
    void append(const std::string& text);

  private:
    void watchNext();
    void watchSignals();
    void sayOnce(const std::string& line);

    std::string m_name;
    std::string m_nextName;
    SharedLife& m_shared;
    LifeLock& m_own;
    NotedCrashes m_crashes;
    LifeLock& m_next;
    const HeldSignals& m_signals;
    const Say& m_say;
    std::mutex m_mutex;
    std::string m_appended; ///< under m_mutex
    std::atomic<bool> m_isOver{false};
    std::jthread m_watchesNext; ///< last, since both use all above
    std::jthread m_watchesSignals;
};

} // namespace cdr::ranks
