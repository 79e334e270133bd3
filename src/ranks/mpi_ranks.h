#pragma once

#include <ranks/ranks.h>

#include <memory>

namespace cdr::ranks {

/// The ranks of an MPI run, which the process joins; it leaves when the object goes.
std::unique_ptr<Run> makeMpiRanks(Explain explain, Say say);

} // namespace cdr::ranks
