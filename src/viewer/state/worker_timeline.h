#pragma once

#include <cdr/platform/trace.h>
#include <cdr/render/submit/submission.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

/// What one worker did, and when, milliseconds since the frame began.
struct TimelineJob {
    std::size_t worker = 0;
    std::optional<std::size_t> cascade; ///< that it recorded; empty for culling and binning
    std::size_t draws = 0;
    double beginMs = 0.0;
    double endMs = 0.0;
};

/// A stage of the frame, milliseconds since it began.
struct TimelineStage {
    std::string name; ///< "cull", "split", "bin", "record" or "execute"
    double beginMs = 0.0;
    double endMs = 0.0;
};

/// Who worked on what during one frame.
struct WorkerTimeline {
    std::size_t workers = 0;
    double lengthMs = 0.0;             ///< end of the last stage or job
    std::vector<TimelineStage> stages; ///< in order
    std::vector<TimelineJob> jobs;     ///< by worker, each worker's in order
};

/// All that a trace holds, which is one frame: platform::Trace::forget() goes before each. On the thread that drives the
/// frame, between frames.
WorkerTimeline timelineOf(const platform::Trace& trace);

/// Draws of each cascade, counted from the jobs that recorded them. None where the device chooses them.
std::optional<std::vector<std::size_t>> drawsByCascade(const WorkerTimeline& timeline, std::size_t cascades,
                                                       render::Submission submission);

} // namespace cdr::viewer
