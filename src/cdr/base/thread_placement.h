#pragma once

#include <cstddef>
#include <vector>

namespace cdr::base {

/// Which CPUs a pool's threads run on.
enum class Placement {
    free,   ///< wherever the kernel puts them; it may leave two on one CPU for milliseconds
    pinned, ///< worker i on the i-th CPU this process may use, counted round: for measuring
};

/// CPUs the calling thread may run on, ascending; empty where the system does not say.
std::vector<std::size_t> allowedCpus();

/// Keeps the calling thread on one CPU, until it is destroyed by the same thread. Does nothing where the
/// system has no such call.
class PinnedThread {
  public:
    /// @param number of the CPU among `cpus`, counted round; nothing happens when there are none.
    PinnedThread(std::size_t number, const std::vector<std::size_t>& cpus);
    ~PinnedThread();
    PinnedThread(const PinnedThread&) = delete;
    PinnedThread& operator=(const PinnedThread&) = delete;

  private:
    std::vector<std::size_t> m_before;
};

} // namespace cdr::base
