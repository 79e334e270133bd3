#include <cdr/base/error.h>
#include <cdr/platform/process_cpus.h>
#include <cdr/platform/worker_pool.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using cdr::platform::allowCpus;
using cdr::platform::allowedCpus;
using cdr::platform::cpusOfParent;
using cdr::platform::PinnedThread;
using cdr::platform::Placement;
using cdr::platform::WorkerPool;

class WorkerPoolThreads : public testing::TestWithParam<std::size_t> {};

TEST_P(WorkerPoolThreads, RunsEveryJobOnce) {
    WorkerPool pool(GetParam());
    for (int batch = 0; batch < 200; ++batch) {
        std::vector<int> runs(97, 0);
        std::vector<std::size_t> worker(97, 0);
        pool.run(runs.size(), [&](std::size_t job, std::size_t who) {
            ++runs[job];
            worker[job] = who;
        });
        for (std::size_t job = 0; job < runs.size(); ++job) {
            ASSERT_EQ(runs[job], 1);
            ASSERT_LT(worker[job], pool.threads());
        }
    }
}

TEST_P(WorkerPoolThreads, RethrowsTheFirstFailureByJobAndGoesOn) {
    WorkerPool pool(GetParam());
    for (int batch = 0; batch < 50; ++batch) {
        std::atomic<int> ended{0};
        try {
            pool.run(40, [&](std::size_t job, std::size_t) {
                ++ended;
                if (job % 7 == 3) {
                    throw std::runtime_error(std::to_string(job));
                }
            });
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "3");
        }
        EXPECT_EQ(ended, 40);
    }
    int runs = 0;
    pool.run(1, [&](std::size_t, std::size_t) { ++runs; });
    EXPECT_EQ(runs, 1);
}

/// Jobs that wait for each other need as many workers. Others wake late, and find the batch gone or the next one.
TEST_P(WorkerPoolThreads, RunsFewJobsAtTheSameTime) {
    WorkerPool pool(GetParam());
    const std::size_t jobs = std::min<std::size_t>(GetParam(), 3);
    std::barrier together(static_cast<std::ptrdiff_t>(jobs));
    for (std::size_t batch = 0; batch < 1'000; ++batch) {
        std::vector<std::size_t> runs(jobs, 0);
        pool.run(jobs, [&](std::size_t job, std::size_t) {
            together.arrive_and_wait();
            runs[job] += batch + job;
        });
        for (std::size_t job = 0; job < jobs; ++job) {
            ASSERT_EQ(runs[job], batch + job);
        }
    }
}

TEST_P(WorkerPoolThreads, RunsNoJobs) {
    WorkerPool pool(GetParam());
    pool.run(0, [](std::size_t, std::size_t) { FAIL(); });
}

INSTANTIATE_TEST_SUITE_P(Counts, WorkerPoolThreads, testing::Values(1, 2, 3, 8, 16));

TEST(WorkerPool, OneThreadRunsOnTheCaller) {
    WorkerPool pool(1);
    const auto caller = std::this_thread::get_id();
    pool.run(10, [&](std::size_t, std::size_t worker) {
        EXPECT_EQ(worker, 0u);
        EXPECT_EQ(std::this_thread::get_id(), caller);
    });
}

TEST(WorkerPool, RefusesImpossibleCounts) {
    EXPECT_THROW(WorkerPool(0), cdr::base::InputError);
    EXPECT_THROW(WorkerPool(WorkerPool::kMaxThreads + 1), cdr::base::InputError);
}

TEST(EvenRange, CoversWithoutGapInNearlyEqualParts) {
    for (const std::size_t count : {0u, 1u, 5u, 100u, 101u}) {
        for (const std::size_t parts : {1u, 2u, 3u, 7u}) {
            std::size_t next = 0;
            for (std::size_t part = 0; part < parts; ++part) {
                const auto range = cdr::platform::evenRange(count, part, parts);
                EXPECT_EQ(range.begin, next);
                EXPECT_LE(range.size(), count / parts + 1);
                EXPECT_GE(range.size(), count / parts);
                next = range.end;
            }
            EXPECT_EQ(next, count);
        }
    }
}

TEST(WorkerPool, PinsItsThreadsAndNotTheCaller) {
    const std::vector<std::size_t> cpus = allowedCpus();
    if (cpus.empty()) {
        GTEST_SKIP() << "this system does not say where threads run";
    }
    WorkerPool pool(3, Placement::pinned);
    std::vector<std::vector<std::size_t>> seen(3);
    // Each worker waits for the others, so that all three take one job.
    std::barrier everyone(3);
    pool.run(3, [&](std::size_t, std::size_t worker) {
        seen[worker] = allowedCpus();
        everyone.arrive_and_wait();
    });
    EXPECT_EQ(seen[0], cpus);
    EXPECT_EQ(seen[1], std::vector{cpus[1 % cpus.size()]});
    EXPECT_EQ(seen[2], std::vector{cpus[2 % cpus.size()]});
}

TEST(AllowedCpus, CanBeChosen) {
    const std::vector<std::size_t> cpus = allowedCpus();
    if (cpus.empty()) {
        GTEST_SKIP() << "this system does not say where threads run";
    }
    EXPECT_FALSE(cpusOfParent().empty());
    std::thread([&] { // which leaves the CPUs of the others as they are
        allowCpus({cpus.back()});
        EXPECT_EQ(allowedCpus(), std::vector{cpus.back()});
        std::thread([&] { EXPECT_EQ(allowedCpus(), std::vector{cpus.back()}); }).join();
        allowCpus({});
        EXPECT_EQ(allowedCpus(), std::vector{cpus.back()});
    })
        .join();
    EXPECT_EQ(allowedCpus(), cpus);
}

TEST(PinnedThread, GivesTheCpusBack) {
    const std::vector<std::size_t> cpus = allowedCpus();
    if (cpus.empty()) {
        GTEST_SKIP() << "this system does not say where threads run";
    }
    {
        const PinnedThread pin(0, cpus);
        EXPECT_EQ(allowedCpus(), std::vector{cpus.front()});
    }
    EXPECT_EQ(allowedCpus(), cpus);
}

} // namespace
