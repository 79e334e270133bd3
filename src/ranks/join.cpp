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

std::unique_ptr<Ranks> join(Explain explain, Say say) {
    return isLaunched() ? makeMpiRanks(std::move(explain), std::move(say)) : std::make_unique<OneProcess>();
}

#else

std::unique_ptr<Ranks> join(Explain, Say) {
    const char* size = std::getenv("OMPI_COMM_WORLD_SIZE");
    const char* sizeOfMpich = std::getenv("PMI_SIZE");
    const std::string count = size != nullptr ? size : sizeOfMpich != nullptr ? sizeOfMpich : "1";
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
