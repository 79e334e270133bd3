#pragma once

#include <ranks/ranks.h>

#include <memory>
#include <string>

namespace cdr::ranks {

/// The ranks of an MPI run, which the process joins; it leaves when the object goes.
std::unique_ptr<Ranks> makeMpiRanks(Explain explain, Say say);

/// The library's own name and version, as far as its first comma or line break.
std::string mpiLibraryVersion();

} // namespace cdr::ranks
