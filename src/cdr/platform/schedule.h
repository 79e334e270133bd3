#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::platform {

/// A job of a batch and the worker that runs it.
struct ScheduledJob {
    std::size_t job = 0;
    std::size_t worker = 0;

    bool operator==(const ScheduledJob&) const = default;
};

/// How many ways there are to run so many jobs one after the other: any order, each on any worker.
/// The largest number where there are more.
std::uint64_t scheduleCount(std::size_t jobs, std::size_t workers);

/// One of those ways. Numbers below scheduleCount() give different ones; number 0 runs the jobs in their order on worker 0.
std::vector<ScheduledJob> scheduleOf(std::uint64_t number, std::size_t jobs, std::size_t workers);

} // namespace cdr::platform
