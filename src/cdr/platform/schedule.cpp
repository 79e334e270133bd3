#include <cdr/platform/schedule.h>

#include <limits>
#include <numeric>

namespace cdr::platform {

std::uint64_t scheduleCount(std::size_t jobs, std::size_t workers) {
    std::uint64_t count = 1;
    for (std::size_t left = jobs; left > 0; --left) {
        const std::uint64_t choices = left * workers;
        if (count > std::numeric_limits<std::uint64_t>::max() / choices) {
            return std::numeric_limits<std::uint64_t>::max();
        }
        count *= choices;
    }
    return count;
}

std::vector<ScheduledJob> scheduleOf(std::uint64_t number, std::size_t jobs, std::size_t workers) {
    std::vector<std::size_t> left(jobs);
    std::iota(left.begin(), left.end(), std::size_t{0});
    std::vector<ScheduledJob> schedule;
    while (!left.empty()) {
        const std::uint64_t choices = left.size() * workers;
        const std::uint64_t choice = number % choices;
        number /= choices;
        const auto job = left.begin() + static_cast<std::ptrdiff_t>(choice / workers);
        schedule.push_back({.job = *job, .worker = static_cast<std::size_t>(choice % workers)});
        left.erase(job);
    }
    return schedule;
}

} // namespace cdr::platform
