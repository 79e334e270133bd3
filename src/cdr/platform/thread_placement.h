#pragma once

#include <cdr/base/export.h>

#include <cstddef>
#include <vector>

namespace cdr::platform {

/// Which CPUs a pool's threads run on.
enum class Placement {
    free,   ///< chosen by the kernel, which may leave two on one CPU for milliseconds
    pinned, ///< worker i on the i-th CPU that this process may use, modulo their number: for measuring
};

/// CPUs that the calling thread may run on, ascending. Empty where the system cannot tell.
/// @errors None.
CDR_EXPORT std::vector<std::size_t> allowedCpus();

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

} // namespace cdr::platform
