#include <cdr/platform/worker_pool.h>
#include <viewer/state/worker_timeline.h>

#include <gtest/gtest.h>

namespace cdr::viewer {

namespace {

using Clock = platform::Trace::Clock;

Clock::time_point at(int ms) {
    return Clock::time_point(std::chrono::milliseconds(1'000'000 + ms));
}

void addFrame(platform::Trace& trace, int start) {
    trace.beginFrame("frame");
    trace.addStage("cull", at(start), at(start + 2));
    trace.addJob(
        0, {.index = 4, .cascade = std::nullopt, .draws = 0, .begin = at(start + 1), .end = at(start + 2)});
    trace.addJob(1, {.index = 0, .cascade = 3, .draws = 40, .begin = at(start + 3), .end = at(start + 7)});
    trace.addJob(0, {.index = 2, .cascade = 2, .draws = 50, .begin = at(start + 3), .end = at(start + 9)});
    trace.addStage("record", at(start + 2), at(start + 9));
    trace.addStage("execute", at(start + 9), at(start + 20));
}

TEST(WorkerTimeline, IsTheFrameInMilliseconds) {
    platform::Trace trace(2);
    EXPECT_TRUE(timelineOf(trace).stages.empty());
    EXPECT_EQ(timelineOf(trace).workers, 2u);
    addFrame(trace, 500);
    const WorkerTimeline timeline = timelineOf(trace);
    ASSERT_EQ(timeline.stages.size(), 3u);
    EXPECT_EQ(timeline.stages[1].name, "record");
    EXPECT_EQ(timeline.stages[1].beginMs, 2.0);
    EXPECT_EQ(timeline.stages[1].endMs, 9.0);
    EXPECT_EQ(timeline.lengthMs, 20.0);
    ASSERT_EQ(timeline.jobs.size(), 3u);
    EXPECT_EQ(timeline.jobs[0].worker, 0u);
    EXPECT_FALSE(timeline.jobs[0].cascade);
    EXPECT_EQ(timeline.jobs[1].cascade, 2u);
    EXPECT_EQ(timeline.jobs[1].draws, 50u);
    EXPECT_EQ(timeline.jobs[2].worker, 1u);
    EXPECT_EQ(timeline.jobs[2].beginMs, 3.0);
    EXPECT_EQ(timeline.jobs[2].endMs, 7.0);
}

TEST(WorkerTimeline, AFrameWithoutStagesStillHasItsJobs) {
    platform::Trace trace(1);
    trace.beginFrame("frame");
    trace.addJob(0, {.index = 0, .cascade = 1, .draws = 5, .begin = at(7), .end = at(9)});
    const WorkerTimeline timeline = timelineOf(trace);
    EXPECT_TRUE(timeline.stages.empty());
    ASSERT_EQ(timeline.jobs.size(), 1u);
    EXPECT_EQ(timeline.jobs.front().beginMs, 0.0);
    EXPECT_EQ(timeline.lengthMs, 2.0);
}

TEST(WorkerTimeline, ATraceThatIsForgottenGoesOnForEver) {
    platform::Trace trace(2);
    for (int frame = 0; frame < 2000; ++frame) {
        trace.forget();
        addFrame(trace, 100 * frame);
        ASSERT_EQ(trace.stages().size(), 3u);
        ASSERT_EQ(trace.stages().front().frame, 1u);
        ASSERT_EQ(trace.jobs(0).size(), 2u);
        ASSERT_EQ(timelineOf(trace).jobs.size(), 3u);
    }
    trace.forget();
    EXPECT_TRUE(timelineOf(trace).jobs.empty());
}

TEST(WorkerTimeline, HoldsWhatAPoolDid) {
    platform::Trace trace(3);
    platform::WorkerPool workers(3);
    workers.setTrace(&trace);
    trace.beginFrame("frame");
    const Clock::time_point begin = Clock::now();
    workers.run(20, [](std::size_t, std::size_t) {});
    trace.addStage("cull", begin, Clock::now());
    const WorkerTimeline timeline = timelineOf(trace);
    EXPECT_EQ(timeline.jobs.size(), 20u);
    for (std::size_t i = 0; i < timeline.jobs.size(); ++i) {
        const TimelineJob& job = timeline.jobs[i];
        EXPECT_GE(job.beginMs, 0.0);
        EXPECT_GE(job.endMs, job.beginMs);
        EXPECT_LE(job.endMs, timeline.lengthMs);
        if (i > 0 && timeline.jobs[i - 1].worker == job.worker) {
            EXPECT_GE(job.beginMs, timeline.jobs[i - 1].endMs);
        } else if (i > 0) {
            EXPECT_GT(job.worker, timeline.jobs[i - 1].worker);
        }
    }
}

TEST(WorkerTimeline, KnowsNoDrawsOfCascadesThatTheDeviceChooses) {
    const WorkerTimeline timeline{.workers = 2,
                                  .stages = {},
                                  .jobs = {{.cascade = 1, .draws = 3},
                                           {.worker = 1, .cascade = 1, .draws = 2},
                                           {.cascade = 7, .draws = 9}}};
    EXPECT_EQ(drawsByCascade(timeline, 3, render::Submission::secondaries),
              (std::vector<std::size_t>{0, 5, 0}));
    EXPECT_EQ(drawsByCascade(timeline, 3, render::Submission::gpuDriven), std::nullopt);
}

} // namespace

} // namespace cdr::viewer
