#pragma once

#include <cdr/platform/trace.h>

#include <chrono>
#include <utility>

namespace cdr::platform {

inline double millisecondsBetween(Trace::Clock::time_point begin, Trace::Clock::time_point end) {
    return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// Times one stage after the other.
class StageWatch {
  public:
    /// @param trace that the stages are added to; null: none. It must outlive this.
    explicit StageWatch(Trace* trace) : m_trace(trace) {}

    /// Milliseconds since the last call; they were `stage`.
    double lap(const char* stage) {
        const auto now = Trace::Clock::now();
        const auto last = std::exchange(m_last, now);
        if (m_trace != nullptr) {
            m_trace->addStage(stage, last, now);
        }
        return millisecondsBetween(last, now);
    }

  private:
    Trace* m_trace;
    Trace::Clock::time_point m_last = Trace::Clock::now();
};

} // namespace cdr::platform
