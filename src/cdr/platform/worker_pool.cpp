#include <cdr/base/error.h>
#include <cdr/platform/schedule.h>
#include <cdr/platform/worker_pool.h>

#include <atomic>
#include <exception>
#include <string>

namespace cdr::platform {

struct WorkerPool::Batch {
    Batch(const Job& batchBody, std::size_t batchJobs, Trace* batchTrace)
        : body(batchBody),
          jobs(batchJobs),
          trace(batchTrace) {}

    const Job& body;
    const std::size_t jobs;
    Trace* const trace;
    std::atomic<std::size_t> next{0};
    std::mutex errorMutex;
    std::size_t errorJob = static_cast<std::size_t>(-1);
    std::exception_ptr error;

    void work(std::size_t worker) {
        for (std::size_t job = next++; job < jobs; job = next++) {
            runJob(job, worker);
        }
    }

    void runJob(std::size_t job, std::size_t worker) {
        const JobSpan span(trace, worker, job);
        try {
            body(job, worker);
        } catch (...) {
            const std::lock_guard lock(errorMutex);
            if (job < errorJob) {
                errorJob = job;
                error = std::current_exception();
            }
        }
    }
};

WorkerPool::WorkerPool(std::size_t threads, Placement placement) {
    if (threads < 1 || threads > kMaxThreads) {
        throw base::InputError("threads must be 1 to " + std::to_string(kMaxThreads) + ", not " +
                               std::to_string(threads));
    }
    const std::vector<std::size_t> cpus =
        placement == Placement::pinned ? allowedCpus() : std::vector<std::size_t>();
    m_threads.reserve(threads - 1);
    for (std::size_t worker = 1; worker < threads; ++worker) {
        m_threads.emplace_back([this, worker, cpus](const std::stop_token& stop) {
            const PinnedThread pin(worker, cpus);
            serve(stop, worker);
        });
    }
}

WorkerPool::~WorkerPool() = default;

void WorkerPool::run(std::size_t jobs, const Job& body) {
    Batch batch(body, jobs, m_trace);
    // One job needs no second thread.
    const bool shared = jobs > 1 && !m_threads.empty() && !m_schedule;
    if (shared) {
        {
            const std::lock_guard lock(m_mutex);
            m_batch = &batch;
            ++m_batchNumber;
        }
        // After the lock is released, since workers that wake need it.
        wake(jobs - 1);
    }
    if (m_schedule) {
        for (const ScheduledJob& each : scheduleOf(*m_schedule, jobs, threads())) {
            batch.runJob(each.job, each.worker);
        }
    } else {
        batch.work(0);
    }
    if (shared) {
        std::unique_lock lock(m_mutex);
        m_batch = nullptr; // no job is left for workers that wake later
        m_workersIdle.wait(lock, [this] { return m_busyWorkers == 0; });
    }
    if (batch.error) {
        std::rethrow_exception(batch.error);
    }
}

void WorkerPool::wake(std::size_t jobs) {
    if (jobs >= m_threads.size()) {
        m_batchPosted.notify_all();
        return;
    }
    for (std::size_t i = 0; i < jobs; ++i) {
        m_batchPosted.notify_one();
    }
}

void WorkerPool::serve(const std::stop_token& stop, std::size_t worker) {
    std::size_t served = 0;
    std::unique_lock lock(m_mutex);
    while (m_batchPosted.wait(lock, stop, [&] { return m_batch != nullptr && m_batchNumber != served; })) {
        served = m_batchNumber;
        Batch& batch = *m_batch;
        ++m_busyWorkers;
        lock.unlock();
        batch.work(worker);
        lock.lock();
        if (--m_busyWorkers == 0) {
            m_workersIdle.notify_one();
        }
    }
}

} // namespace cdr::platform
