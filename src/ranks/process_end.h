#pragma once

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace cdr::ranks {

/// A lock in memory that processes share. A process that waits for it learns whether the holder let it go or ended with it.
/// It learns this before the system closes the holder's files or tells its parent.
class LifeLock {
  public:
    LifeLock();
    ~LifeLock() = default; ///< with the memory
    LifeLock(const LifeLock&) = delete;
    LifeLock& operator=(const LifeLock&) = delete;

    /// For the process that it tells of. letGo() comes from the same thread, which ends no earlier.
    void hold();
    void letGo();
    /// For one other process, after hold(): returns when it is held no more.
    /// @return whether the holder ended without letting go.
    bool waitForEnd();

    /// By the process that the lock tells of, from a signal's handler: the signal by which it crashes.
    void noteCrash(int signal) noexcept { m_crash = signal; }
    /// Of a process that has ended: that signal; 0 where it was killed.
    int crash() const { return m_crash; }

  private:
    pthread_mutex_t m_mutex{};
    std::atomic<int> m_crash{0};
    static_assert(std::atomic<int>::is_always_lock_free);
};

/// Until the object is destroyed, notes in a lock by which signal this process crashes. Then the earlier handling of that
/// signal follows. One object at a time, made by the main thread, whose stack may have overflowed.
class NotedCrashes {
  public:
    explicit NotedCrashes(LifeLock& lock);
    ~NotedCrashes();
    NotedCrashes(const NotedCrashes&) = delete;
    NotedCrashes& operator=(const NotedCrashes&) = delete;
};

/// "segmentation fault" and the like, of those that NotedCrashes notes.
const char* nameOfCrash(int signal);

/// Blocks signals that ask a process to end (SIGHUP, SIGINT, SIGTERM) until the object is destroyed. It does so in the calling
/// thread, and in all threads that it starts from then on. A signal that the process ignores stays ignored.
class HeldSignals {
  public:
    HeldSignals();
    ~HeldSignals();
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    /// Waits for one of them: its number, or 0 where none came in time.
    int wait(std::chrono::milliseconds atMost) const;
    /// Ends the wait() of a thread early, unless all are ignored.
    void wake(std::jthread& waiting) const;

  private:
    std::vector<int> m_numbers;
};

/// "SIGTERM" and the like, of those that HeldSignals takes.
const char* nameOfSignal(int signal);

/// Ends the process as the signal does where nobody holds it. 0 stands for SIGTERM.
[[noreturn]] void endBySignal(int signal);

} // namespace cdr::ranks
