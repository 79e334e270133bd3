#include <cdr/platform/trace.h>
#include <cdr/platform/worker_pool.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <map>
#include <set>
#include <string>
#include <thread>

namespace {

using cdr::platform::JobSpan;
using cdr::platform::Trace;
using cdr::platform::WorkerPool;
using nlohmann::ordered_json;

/// Names of the events of each track, by the track's own name.
std::map<std::string, std::multiset<std::string>> namesByTrack(const ordered_json& document) {
    std::map<int, std::string> tracks;
    for (const ordered_json& event : document.at("traceEvents")) {
        if (event.at("name") == "thread_name") {
            tracks[event.at("tid")] = event.at("args").at("name");
        }
    }
    std::map<std::string, std::multiset<std::string>> names;
    for (const ordered_json& event : document.at("traceEvents")) {
        if (event.at("ph") == "X") {
            EXPECT_GE(event.at("dur").get<double>(), 0.0);
            names[tracks.at(event.at("tid"))].insert(event.at("name").get<std::string>());
        }
    }
    return names;
}

/// A stage of jobs on two workers; with cascades, job j draws cascade j % 2.
void runStage(Trace& trace, WorkerPool& workers, const char* name, bool cascades) {
    const auto begin = Trace::Clock::now();
    workers.run(8, [&](std::size_t job, std::size_t worker) {
        const JobSpan span(cascades ? &trace : nullptr, worker, job, job % 2, 10);
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    });
    trace.addStage(name, begin, Trace::Clock::now());
}

ordered_json traceTwoFrames() {
    Trace trace(2);
    WorkerPool workers(2);
    workers.setTrace(&trace);
    for (const char* frame : {"first", "second"}) {
        trace.beginFrame(frame);
        runStage(trace, workers, "cull", false);
        runStage(trace, workers, "record", true);
        const auto begin = Trace::Clock::now();
        trace.addStage("execute", begin, Trace::Clock::now());
    }
    return ordered_json::parse(trace.toJson());
}

TEST(Trace, HasATrackForEveryWorkerCascadeAndTheDevice) {
    const auto names = namesByTrack(traceTwoFrames());
    EXPECT_EQ(names.at("frames"), (std::multiset<std::string>{"first", "second"}));
    EXPECT_EQ(names.at("stages"), (std::multiset<std::string>{"cull", "cull", "record", "record"}));
    EXPECT_EQ(names.at("device"), (std::multiset<std::string>{"execute", "execute"}));
    EXPECT_EQ(names.at("cascade 0").count("record cascade 0"), 2u);
    EXPECT_EQ(names.at("cascade 1").count("record cascade 1"), 2u);
    std::map<std::string, std::size_t> jobs;
    for (const char* worker : {"worker 0", "worker 1"}) {
        for (const std::string& name :
             names.contains(worker) ? names.at(worker) : std::multiset<std::string>()) {
            ++jobs[name];
        }
    }
    const std::map<std::string, std::size_t> expected{
        {"cull", 16}, {"record", 16}, {"cascade 0", 8}, {"cascade 1", 8}};
    EXPECT_EQ(jobs, expected);
}

/// The format allows events of one track to nest, never to cross.
TEST(Trace, EventsOfATrackNest) {
    std::map<int, std::vector<std::pair<double, double>>> spans;
    const ordered_json document = traceTwoFrames();
    for (const ordered_json& event : document.at("traceEvents")) {
        if (event.at("ph") == "X") {
            const double begin = event.at("ts");
            spans[event.at("tid")].emplace_back(begin, begin + event.at("dur").get<double>());
        }
    }
    constexpr double kRounding = 1e-3;
    for (const auto& [track, list] : spans) {
        for (const auto& [begin, end] : list) {
            for (const auto& [otherBegin, otherEnd] : list) {
                const bool crosses = begin + kRounding < otherBegin && otherBegin + kRounding < end &&
                                     end + kRounding < otherEnd;
                EXPECT_FALSE(crosses) << "track " << track;
            }
        }
    }
}

TEST(Trace, CountsWhatItDoesNotKeep) {
    Trace trace(1);
    for (std::size_t i = 0; i < Trace::kMaxEventsPerTrack + 5; ++i) {
        trace.addJob(0, {.index = i, .cascade = {}, .draws = 0, .begin = {}, .end = {}});
    }
    EXPECT_TRUE(trace.toJson().ends_with(R"("otherData":{"dropped_events":5}})"
                                         "\n"));
}

TEST(Trace, KeepsNoMoreFramesThanEventsAndNoneOnceStopped) {
    Trace trace(1);
    for (std::size_t i = 0; i < Trace::kMaxEventsPerTrack; ++i) {
        trace.beginFrame("frame");
    }
    const Trace::Clock::time_point now = Trace::Clock::now();
    trace.addStage("cull", now, now);
    trace.stop();
    trace.beginFrame("ignored");
    trace.addStage("ignored", now, now);
    ASSERT_EQ(trace.stages().size(), 1u);
    EXPECT_EQ(trace.stages()[0].frame, Trace::kMaxEventsPerTrack);
    const ordered_json document = ordered_json::parse(trace.toJson());
    EXPECT_EQ(document.at("otherData").at("dropped_events"), 1u) << "the frame that has no name";
    const auto names = namesByTrack(document);
    EXPECT_FALSE(names.contains("frames"));
    EXPECT_EQ(names.at("stages").size(), 1u);
    trace.forget();
    EXPECT_TRUE(namesByTrack(ordered_json::parse(trace.toJson())).empty());
}

TEST(Trace, AnEmptyOneIsStillATrace) {
    const ordered_json document = ordered_json::parse(Trace(1).toJson());
    EXPECT_TRUE(document.at("traceEvents").is_array());
    EXPECT_TRUE(namesByTrack(document).empty());
}

} // namespace
