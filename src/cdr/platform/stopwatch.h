#pragma once

#include <chrono>

namespace cdr::platform {

/// Time that has passed since it was made, or since its last lap.
class Stopwatch {
  public:
    double milliseconds() const { return millisecondsUntil(Clock::now()); }
    double seconds() const { return milliseconds() / 1e3; }
    /// The same as milliseconds(); the next lap begins.
    double lap() {
        const Clock::time_point now = Clock::now();
        const double passed = millisecondsUntil(now);
        m_begin = now;
        return passed;
    }

  private:
    using Clock = std::chrono::steady_clock;

    double millisecondsUntil(Clock::time_point end) const {
        return std::chrono::duration<double, std::milli>(end - m_begin).count();
    }

    Clock::time_point m_begin = Clock::now();
};

} // namespace cdr::platform
