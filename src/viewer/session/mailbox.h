#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace cdr::viewer {

/// One slot between two threads: putting replaces what lies there, taking empties it. Nothing queues, so the
/// taker always gets the newest and is never behind.
template <typename Letter>
class Mailbox {
  public:
    void put(Letter letter) {
        {
            const std::lock_guard lock(m_mutex);
            m_letter = std::move(letter);
        }
        m_arrived.notify_one();
    }

    std::optional<Letter> take() {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_letter, std::nullopt);
    }

    /// Waits for a letter; empty once a stop is requested.
    std::optional<Letter> wait(const std::stop_token& stop) {
        std::unique_lock lock(m_mutex);
        if (!m_arrived.wait(lock, stop, [this] { return m_letter.has_value(); })) {
            return std::nullopt;
        }
        return std::exchange(m_letter, std::nullopt);
    }

    bool isEmpty() const {
        const std::lock_guard lock(m_mutex);
        return !m_letter.has_value();
    }

  private:
    mutable std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    std::optional<Letter> m_letter;
};

} // namespace cdr::viewer
