#include <cdr/base/error.h>

#include <ranks/join.h>
#include <ranks/mpi_ranks.h>
#include <ranks/one_process.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace cdr::ranks {

namespace {

/// By the variables that Open MPI's, MPICH's and Slurm's launchers set. Asking MPI itself takes half a second.
bool isLaunched() {
    constexpr std::array kVariables{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
    return std::ranges::any_of(kVariables, [](const char* name) { return std::getenv(name) != nullptr; });
}

} // namespace

#ifdef CDR_HAS_MPI

std::unique_ptr<Run> join(Explain explain, Say say) {
    return isLaunched() ? makeMpiRanks(std::move(explain), std::move(say)) : std::make_unique<OneProcess>();
}

#else

std::unique_ptr<Run> join(Explain, Say) {
    std::string count = "1";
    for (const char* name :
         {"SLURM_STEP_NUM_TASKS", "PMI_SIZE", "OMPI_COMM_WORLD_SIZE"}) { // the last one holds
        if (const char* size = std::getenv(name)) { // Slurm has its own where it starts ranks by PMIx
            count = size;
        }
    }
    if (isLaunched() && count != "1") {
        throw base::InputError("started as one of " + count + " ranks, but this cdr was built without MPI");
    }
    return std::make_unique<OneProcess>();
}

std::string mpiLibrary() {
    return {};
}

#endif

} // namespace cdr::ranks
