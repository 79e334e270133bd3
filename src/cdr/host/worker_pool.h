#pragma once

#include <cdr/base/export.h>
#include <cdr/host/thread_placement.h>
#include <cdr/host/trace.h>

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

/// Worker threads and the traces of what they did.
namespace cdr::host {

/// A fixed set of threads that run the jobs of one batch at a time.
///
/// The calling thread is worker 0 and takes part, so a pool of one thread starts no thread and runs the same
/// code. Jobs are handed out by index from an atomic counter; which worker runs a job is not defined, so
/// results must be stored by job index, never in completion order.
class CDR_EXPORT WorkerPool {
  public:
    /// @param threads workers, the caller included: 1 to kMaxThreads, else InputError.
    /// @param placement of the threads it starts; the caller, worker 0, stays as it is.
    explicit WorkerPool(std::size_t threads, Placement placement = Placement::free);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    /// A job: its index in [0, jobs) and the worker in [0, threads()) that runs it.
    using Job = std::function<void(std::size_t job, std::size_t worker)>;

    /// Runs `body` once for each job in [0, jobs) and returns when all have ended. The first exception by job
    /// index is rethrown after the batch. Not reentrant: one batch at a time, from one thread.
    void run(std::size_t jobs, const Job& body);

    /// Traces every job from now on; null for none. Between batches only; the trace must have a track per
    /// worker.
    void setTrace(Trace* trace) { m_trace = trace; }

    /// Workers, the caller included.
    std::size_t threads() const { return m_threads.size() + 1; }

    static constexpr std::size_t kMaxThreads = 256; ///< Most workers of a pool.

  private:
    struct Batch;
    void serve(const std::stop_token& stop, std::size_t worker);

    Trace* m_trace = nullptr;
    std::mutex m_mutex;
    std::condition_variable_any m_batchPosted;
    std::condition_variable m_workersIdle;
    Batch* m_batch = nullptr;
    std::size_t m_batchNumber = 0;
    std::size_t m_busyWorkers = 0;
    std::vector<std::jthread> m_threads;
};

/// A half-open range of indices.
struct IndexRange {
    std::size_t begin = 0; ///< the first
    std::size_t end = 0;   ///< one past the last
    /// How many indices it holds.
    std::size_t size() const { return end - begin; }
};

/// The `part`-th of `parts` contiguous ranges that cover [0, count) with sizes that differ by one at most.
constexpr IndexRange evenRange(std::size_t count, std::size_t part, std::size_t parts) {
    return {count * part / parts, count * (part + 1) / parts};
}

} // namespace cdr::host
