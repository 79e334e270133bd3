#pragma once

#include <optional>
#include <vector>

namespace cdr::measure {

/// How much faster `threads` threads are than one.
struct SpeedUp {
    double threads = 1.0; ///< >= 1
    double factor = 1.0;  ///< > 0; 1 for one thread
};

/// Least-squares fit of Amdahl's law (1967), 1 / factor = s + (1 - s) / threads, for its serial fraction s.
/// It is held to 0, where points scale better than threads can, and to 1, where threads slow the work down. None without a point
/// of more than one thread.
std::optional<double> fitAmdahl(const std::vector<SpeedUp>& points);

/// Gunther's universal scalability law, factor = p / (1 + contention (p - 1) + coherence p (p - 1)).
struct UniversalScalability {
    double contention = 0.0; ///< share of the work that waits in line
    double coherence = 0.0;  ///< cost of each pair of threads keeping in step
};

/// Least-squares fit of p / factor - 1, which is linear in both coefficients. None with fewer than four
/// points, or fewer than two different numbers of threads above one.
std::optional<UniversalScalability> fitUniversalScalability(const std::vector<SpeedUp>& points);

} // namespace cdr::measure
