#include "worker_timeline.h"

#include <algorithm>

namespace cdr::viewer {

WorkerTimeline timelineOf(const platform::Trace& trace) {
    WorkerTimeline timeline{.workers = trace.workers(), .lengthMs = 0.0, .stages = {}, .jobs = {}};
    using TimePoint = platform::Trace::Clock::time_point;
    TimePoint begin = TimePoint::max();
    for (const platform::Trace::Stage& stage : trace.stages()) {
        begin = std::min(begin, stage.begin);
    }
    for (std::size_t worker = 0; worker < trace.workers(); ++worker) {
        for (const platform::Trace::FramedJob& job : trace.jobs(worker)) {
            begin = std::min(begin, job.job.begin);
        }
    }
    const auto since = [&](TimePoint time) {
        const double ms = std::chrono::duration<double, std::milli>(time - begin).count();
        timeline.lengthMs = std::max(timeline.lengthMs, ms);
        return ms;
    };
    for (const platform::Trace::Stage& stage : trace.stages()) {
        timeline.stages.push_back(
            {.name = stage.name, .beginMs = since(stage.begin), .endMs = since(stage.end)});
    }
    for (std::size_t worker = 0; worker < trace.workers(); ++worker) {
        for (const platform::Trace::FramedJob& framed : trace.jobs(worker)) {
            timeline.jobs.push_back({.worker = worker,
                                     .cascade = framed.job.cascade,
                                     .draws = framed.job.draws,
                                     .beginMs = since(framed.job.begin),
                                     .endMs = since(framed.job.end)});
        }
    }
    return timeline;
}

std::optional<std::vector<std::size_t>> drawsByCascade(const WorkerTimeline& timeline, std::size_t cascades,
                                                       render::Submission submission) {
    if (submission == render::Submission::gpuDriven) {
        return std::nullopt;
    }
    std::vector<std::size_t> draws(cascades, 0);
    for (const TimelineJob& job : timeline.jobs) {
        if (job.cascade && *job.cascade < cascades) {
            draws[*job.cascade] += job.draws;
        }
    }
    return draws;
}

} // namespace cdr::viewer
