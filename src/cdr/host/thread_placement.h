#pragma once

#include <cdr/base/export.h>

#include <cstddef>
#include <vector>

namespace cdr::host {

/// Which CPUs a pool's threads run on.
enum class Placement {
    free,   ///< chosen by the kernel, which may leave two on one CPU for milliseconds
    pinned, ///< worker i on the i-th CPU that this process may use, modulo their number: for measuring
};

/// CPUs that the calling thread may run on, ascending. Empty where the system cannot tell.
/// @errors None.
CDR_EXPORT std::vector<std::size_t> allowedCpus();

/// The same of the process that started this one: a launcher of MPI binds those it starts, and not itself.
/// @errors None.
CDR_EXPORT std::vector<std::size_t> cpusOfParent();

/// Lets the calling thread, and threads and processes that it starts from now on, run on these CPUs alone. Without CPUs, and
/// where the system has no such call, nothing happens.
/// @errors None: where one of them is not there, the thread keeps those that it had or has the others.
CDR_EXPORT void allowCpus(const std::vector<std::size_t>& cpus);

/// Keeps the calling thread on one CPU until the object is destroyed, by the same thread. Does nothing where
/// the system has no such call.
/// @threads Belongs to the thread that made it.
/// @errors None: a CPU that is not there leaves the thread as it is.
class CDR_EXPORT PinnedThread {
  public:
    /// @param number of the CPU among `cpus`, modulo their number. Without CPUs nothing happens.
    PinnedThread(std::size_t number, const std::vector<std::size_t>& cpus);
    ~PinnedThread();
    PinnedThread(const PinnedThread&) = delete;
    PinnedThread& operator=(const PinnedThread&) = delete;

  private:
    std::vector<std::size_t> m_before;
};

} // namespace cdr::host
