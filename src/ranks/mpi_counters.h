#pragma once

#include <mpi.h>

#include <cstdint>

namespace cdr::ranks {

/// Numbers on the first rank that all ranks read and change; the first rank need not take part. All ranks make it at once. It
/// must be destroyed before MPI ends.
class MpiCounters {
  public:
    enum Which : MPI_Aint {
        next = 0, ///< unit that is claimed next
        taken = 1 ///< units that the first rank has taken
    };

    MpiCounters();
    ~MpiCounters();
    MpiCounters(const MpiCounters&) = delete;
    MpiCounters& operator=(const MpiCounters&) = delete;

    std::uint64_t get(Which which) { return change(which, 0, MPI_NO_OP); }
    /// The number before.
    std::uint64_t add(Which which, std::uint64_t amount) { return change(which, amount, MPI_SUM); }
    void set(Which which, std::uint64_t value) { change(which, value, MPI_REPLACE); }

  private:
    std::uint64_t change(Which which, std::uint64_t value, MPI_Op how);

    void* m_memory = nullptr;
    MPI_Win m_window = MPI_WIN_NULL;
};

} // namespace cdr::ranks
