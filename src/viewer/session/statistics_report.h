#pragma once

#include <viewer/state/model/performance_model.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cdr::viewer {

/// What --statistics prints: rendered frames a second, the stages, and how evenly the interface was drawn.
/// @param intervals between frames of the interface, milliseconds.
std::string statisticsReport(const PerformanceModel& performance, std::uint64_t results, double seconds,
                             const std::vector<double>& intervals);

} // namespace cdr::viewer
