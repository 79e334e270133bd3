#include <cdr/platform/schedule.h>
#include <cdr/platform/worker_pool.h>

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace cdr::platform {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs pairsOf(const std::vector<ScheduledJob>& schedule) {
    Pairs pairs;
    for (const ScheduledJob& each : schedule) {
        pairs.emplace_back(each.job, each.worker);
    }
    return pairs;
}

TEST(Schedules, AreAllThatThereAre) {
    EXPECT_EQ(scheduleCount(0, 3), 1u);
    EXPECT_EQ(scheduleCount(4, 2), 24u * 16u);
    EXPECT_EQ(scheduleCount(100, 2), std::numeric_limits<std::uint64_t>::max());
    std::set<Pairs> all;
    for (std::uint64_t number = 0; number < scheduleCount(4, 2); ++number) {
        const Pairs pairs = pairsOf(scheduleOf(number, 4, 2));
        std::set<std::size_t> jobs;
        for (const auto& [job, worker] : pairs) {
            jobs.insert(job);
            EXPECT_LT(worker, 2u);
        }
        EXPECT_EQ(jobs, (std::set<std::size_t>{0, 1, 2, 3}));
        all.insert(pairs);
    }
    EXPECT_EQ(all.size(), scheduleCount(4, 2));
}

TEST(Schedules, BeginWithTheOrderOfTheJobs) {
    EXPECT_EQ(pairsOf(scheduleOf(0, 3, 5)), (Pairs{{0, 0}, {1, 0}, {2, 0}}));
    EXPECT_TRUE(scheduleOf(7, 0, 2).empty());
}

TEST(Schedules, AreKeptToByAPoolOnItsCaller) {
    WorkerPool pool(3);
    const auto caller = std::this_thread::get_id();
    for (const std::uint64_t number : {std::uint64_t{0}, std::uint64_t{1234}, ~std::uint64_t{0}}) {
        pool.setSchedule(number);
        Pairs ran;
        pool.run(6, [&](std::size_t job, std::size_t worker) {
            EXPECT_EQ(std::this_thread::get_id(), caller);
            ran.emplace_back(job, worker);
        });
        EXPECT_EQ(ran, pairsOf(scheduleOf(number, 6, 3)));
    }
}

TEST(Schedules, EndInTheErrorOfTheLowestJob) {
    WorkerPool pool(2);
    pool.setSchedule(scheduleCount(5, 2) - 1); // the last job first
    try {
        pool.run(5, [](std::size_t job, std::size_t) { throw std::runtime_error(std::to_string(job)); });
        FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "0");
    }
}

} // namespace
} // namespace cdr::platform
