#pragma once

#include <mpi.h>
#include <ranks/rank_watch.h>
#include <ranks/ranks.h>

#include <cstddef>
#include <vector>

namespace cdr::ranks {

/// The place of this process among all of the MPI run, except for what learnMachine() fills in.
Place placeAmongAll();

/// What the ranks of one machine tell each other, and the memory that they share. All ranks of a run make it at once. It must
/// be destroyed before MPI ends.
class MpiMachine {
  public:
    MpiMachine();
    ~MpiMachine();
    MpiMachine(const MpiMachine&) = delete;
    MpiMachine& operator=(const MpiMachine&) = delete;

    /// By rank of the machine, the CPUs that it may use.
    std::vector<Cpus> cpusOfRanks() const;
    /// By rank of the machine, its number among all.
    std::vector<std::size_t> numbersOfRanks() const;
    SharedLife& sharedLife() const { return *m_life; }
    /// By rank of the machine. This rank's is held by the thread that made the object.
    LifeLock* locks() const { return m_locks; }

  private:
    MPI_Comm m_ranks = MPI_COMM_NULL;
    MPI_Win m_memory = MPI_WIN_NULL;
    std::size_t m_count = 1;
    SharedLife* m_life = nullptr; ///< in m_memory
    LifeLock* m_locks = nullptr;  ///< in m_memory
};

} // namespace cdr::ranks
