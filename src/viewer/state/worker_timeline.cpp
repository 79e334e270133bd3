#include "worker_timeline.h"

#include <algorithm>

namespace cdr::viewer {

namespace {

using TimePoint = platform::Trace::Clock::time_point;

/// The newest frame that anything belongs to; empty when nothing was recorded.
std::optional<std::size_t> lastFrame(const platform::Trace& trace) {
    std::optional<std::size_t> last;
    const auto consider = [&](std::size_t frame) { last = std::max(last.value_or(frame), frame); };
    if (!trace.stages().empty()) {
        consider(trace.stages().back().frame);
    }
    for (std::size_t worker = 0; worker < trace.workers(); ++worker) {
        if (!trace.jobs(worker).empty()) {
            consider(trace.jobs(worker).back().frame);
        }
    }
    return last;
}

/// Those of a frame, which were recorded last.
template <typename Event>
std::span<const Event> eventsOf(std::span<const Event> events, std::size_t frame) {
    const auto first = std::ranges::find_if(events, [&](const Event& event) { return event.frame == frame; });
    return events.subspan(static_cast<std::size_t>(first - events.begin()));
}

TimePoint beginOf(const platform::Trace& trace, std::size_t frame) {
    TimePoint begin = TimePoint::max();
    for (const platform::Trace::Stage& stage : eventsOf(trace.stages(), frame)) {
        begin = std::min(begin, stage.begin);
    }
    for (std::size_t worker = 0; worker < trace.workers(); ++worker) {
        for (const platform::Trace::FramedJob& job : eventsOf(trace.jobs(worker), frame)) {
            begin = std::min(begin, job.job.begin);
        }
    }
    return begin;
}

} // namespace

WorkerTimeline timelineOf(const platform::Trace& trace) {
    WorkerTimeline timeline{.workers = trace.workers(), .lengthMs = 0.0, .stages = {}, .jobs = {}};
    const std::optional<std::size_t> frame = lastFrame(trace);
    if (!frame) {
        return timeline;
    }
    const TimePoint begin = beginOf(trace, *frame);
    const auto since = [&](TimePoint time) {
        const double ms = std::chrono::duration<double, std::milli>(time - begin).count();
        timeline.lengthMs = std::max(timeline.lengthMs, ms);
        return ms;
    };
    for (const platform::Trace::Stage& stage : eventsOf(trace.stages(), *frame)) {
        timeline.stages.push_back(
            {.name = stage.name, .beginMs = since(stage.begin), .endMs = since(stage.end)});
    }
    for (std::size_t worker = 0; worker < trace.workers(); ++worker) {
        for (const platform::Trace::FramedJob& framed : eventsOf(trace.jobs(worker), *frame)) {
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
