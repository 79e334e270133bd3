#pragma once

#include <cdr/base/export.h>
#include <cdr/platform/thread_placement.h>
#include <cdr/platform/trace.h>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

/// Worker threads and the traces of what they did.
/// @threads Functions keep nothing: any thread may call them, many at once.
namespace cdr::platform {

/// A fixed set of threads that run the jobs of one batch at a time.
///
/// The calling thread is worker 0 and takes part, so a pool of one thread starts no thread and runs the same
/// code. Jobs are handed out by index from an atomic counter; which worker runs a job is not defined. So
/// results must be stored by job index, never in completion order.
/// @threads One thread at a time, and never from within a job.
/// @errors None but those that a function names.
class CDR_EXPORT WorkerPool {
  public:
    /// @param threads workers, the caller included: 1 to kMaxThreads.
    /// @param placement of the threads it starts; the caller, worker 0, stays as it is.
    /// @throws base::InputError for another number of threads.
    /// @throws std::system_error when the system starts no more threads.
    explicit WorkerPool(std::size_t threads, Placement placement = Placement::free);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    /// A job: its index in [0, jobs) and the worker in [0, threads()) that runs it.
    using Job = std::function<void(std::size_t job, std::size_t worker)>;

    /// Runs `body` once for each job in [0, jobs) and returns when all have ended. Not reentrant.
    /// @errors What `body` throws: of several the error of the lowest job, once the batch has ended.
    void run(std::size_t jobs, const Job& body);

    /// Traces every job from now on; null for none. Between batches only.
    /// @param trace with a track per worker. It must live until another takes its place, or as long as the pool.
    void setTrace(Trace* trace) { m_trace = trace; }

    /// For tests that results do not depend on the order of jobs. From now on the calling thread runs the jobs of each
    /// batch one after the other. The number chooses one of all possible orders, and which worker each job is told that
    /// it runs on. Call it between batches only.
    /// @param number of the order, any; 0 is the order of the jobs on worker 0.
    void setSchedule(std::uint64_t number) { m_schedule = number; }

    /// Workers, the caller included.
    std::size_t threads() const { return m_threads.size() + 1; }

    static constexpr std::size_t kMaxThreads = 256; ///< Most workers of a pool.

  private:
    struct Batch;
    /// As many workers as there are jobs for them.
    void wake(std::size_t jobs);
    void serve(const std::stop_token& stop, std::size_t worker);

    Trace* m_trace = nullptr;
    std::optional<std::uint64_t> m_schedule;
    std::mutex m_mutex;
    std::condition_variable_any m_batchPosted;
    std::condition_variable m_workersIdle;
    Batch* m_batch = nullptr;
    std::size_t m_batchNumber = 0;
    std::size_t m_busyWorkers = 0; ///< that took part in the batch and have not left it
    std::vector<std::jthread> m_threads;
};

/// A half-open range of indices.
struct IndexRange {
    std::size_t begin = 0; ///< the first
    std::size_t end = 0;   ///< one past the last
    /// How many indices it holds.
    /// @errors None.
    std::size_t size() const { return end - begin; }
};

/// The `part`-th of `parts` contiguous ranges that cover [0, count) with sizes that differ by one at most.
/// @param parts above 0, which is not checked; count * parts must not overflow.
/// @errors None.
constexpr IndexRange evenRange(std::size_t count, std::size_t part, std::size_t parts) {
    return {count * part / parts, count * (part + 1) / parts};
}

} // namespace cdr::platform
