#pragma once

#include <cdr/base/export.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cdr::platform {

/// Records which worker did what and when, for the Chrome and Perfetto trace viewers (Google, "Trace Event
/// Format").
///
/// Each worker adds to a track of its own, so an event takes no lock. Frames and stages come from the one
/// thread that drives the frame. Code that can be traced takes a pointer, null for no trace, and uses it once
/// per job, never per draw.
/// @threads The driving thread calls all but addJob(), and while no batch runs where a function says so.
/// @errors None but those that a function names.
/// @lifetime Spans stay valid until the next event or forget().
class CDR_EXPORT Trace {
  public:
    /// What events are timed by.
    using Clock = std::chrono::steady_clock;

    /// @param workers tracks for workers 0 to workers - 1; 0 is the thread that drives the frame.
    explicit Trace(std::size_t workers);

    /// Later events belong to this frame. Between batches.
    void beginFrame(std::string name);

    /// A stage that the driving thread just ended, such as "cull". The jobs of workers take the name of the
    /// stage around them. "execute" is the device's.
    /// @param name must outlive the trace.
    void addStage(const char* name, Clock::time_point begin, Clock::time_point end);

    /// One part of a stage, which one worker ran.
    struct Job {
        std::size_t index = 0; ///< within its batch
        /// Which cascade it draws. The track of a cascade spans its jobs of a frame.
        std::optional<std::size_t> cascade;
        std::size_t draws = 0;   ///< that it recorded
        Clock::time_point begin; ///< when it began
        Clock::time_point end;   ///< when it ended
    };
    /// A job that `worker` just ended.
    /// @param worker below workers(), which is not checked.
    /// @threads That worker's own; workers may call it at once.
    void addJob(std::size_t worker, const Job& job);

    /// A stage or job that was recorded, and the frame it belongs to: frames count from 1, 0 is before the
    /// first.
    struct Stage {
        const char* name;        ///< as addStage() was given it
        std::size_t frame;       ///< that it belongs to
        Clock::time_point begin; ///< when it began
        Clock::time_point end;   ///< when it ended
    };
    /// A job that was recorded.
    struct FramedJob {
        std::size_t frame; ///< as Stage has it
        Job job;           ///< as it was added
    };
    /// Stages that were recorded, in order.
    std::span<const Stage> stages() const { return m_stages; }
    /// Tracks that there are.
    std::size_t workers() const { return m_workers.size(); }
    /// Jobs of a worker, in order. Between batches.
    /// @throws std::out_of_range for no such worker.
    std::span<const FramedJob> jobs(std::size_t worker) const { return m_workers.at(worker).jobs; }

    /// Forgets everything recorded and keeps the memory, for a trace that is read frame by frame. Between batches.
    void forget();

    /// Ignores everything from now on. Between batches.
    void stop() { m_stopped = true; }

    /// One line of JSON, {"traceEvents": [...]}, microseconds since the trace was made. Between batches.
    std::string toJson() const;
    /// Writes toJson() whole or not at all. Between batches.
    /// @throws base::InputError when the file cannot be made.
    /// @throws base::RunError when it cannot all be written, as on a full disk.
    void write(const std::filesystem::path& path) const;

    /// Most events in a track. The rest are only counted, so that a long run cannot fill the memory.
    static constexpr std::size_t kMaxEventsPerTrack = 300'000;

  private:
    /// On a cache line of its own, since its neighbours belong to other workers.
    struct alignas(64) WorkerTrack {
        std::vector<FramedJob> jobs;
        std::size_t dropped = 0;
    };
    class Writer;

    Clock::time_point m_start = Clock::now();
    std::vector<std::string> m_frames; ///< names
    std::size_t m_frame = 0;           ///< that events belong to, perhaps beyond the names
    std::vector<Stage> m_stages;
    std::size_t m_droppedStages = 0;
    std::vector<WorkerTrack> m_workers;
    bool m_stopped = false;
};

/// Traces one job from construction to destruction. Does nothing without a trace, which must outlive it.
/// @threads The thread of the worker that it names.
/// @errors None.
class JobSpan {
  public:
    /// Begins a job.
    /// @param trace null for none.
    JobSpan(Trace* trace, std::size_t worker, std::size_t index,
            std::optional<std::size_t> cascade = std::nullopt, std::size_t draws = 0)
        : m_trace(trace),
          m_worker(worker) {
        if (m_trace != nullptr) {
            m_job = {
                .index = index, .cascade = cascade, .draws = draws, .begin = Trace::Clock::now(), .end = {}};
        }
    }
    ~JobSpan() {
        if (m_trace != nullptr) {
            m_job.end = Trace::Clock::now();
            m_trace->addJob(m_worker, m_job);
        }
    }
    JobSpan(const JobSpan&) = delete;
    JobSpan& operator=(const JobSpan&) = delete;

  private:
    Trace* m_trace;
    std::size_t m_worker;
    Trace::Job m_job;
};

} // namespace cdr::platform
