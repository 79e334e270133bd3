#include <ranks/mpi_counters.h>

namespace cdr::ranks {

MpiCounters::MpiCounters() {
    MPI_Win_allocate(2 * sizeof(std::uint64_t), sizeof(std::uint64_t), MPI_INFO_NULL, MPI_COMM_WORLD,
                     &m_memory, &m_window);
    MPI_Win_lock_all(0, m_window);
}

MpiCounters::~MpiCounters() {
    MPI_Win_unlock_all(m_window);
    MPI_Win_free(&m_window);
}

std::uint64_t MpiCounters::change(Which which, std::uint64_t value, MPI_Op how) {
    std::uint64_t before = 0;
    MPI_Fetch_and_op(&value, &before, MPI_UINT64_T, 0, which, how, m_window);
    MPI_Win_flush(0, m_window);
    return before;
}

} // namespace cdr::ranks
