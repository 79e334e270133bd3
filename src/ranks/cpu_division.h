#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace cdr::ranks {

/// Numbers of CPUs, ascending.
using Cpus = std::vector<std::size_t>;

/// How the ranks of a machine come to their CPUs.
enum class CpuChoice : std::uint8_t {
    unknown,     ///< the system cannot tell which CPUs a rank may use
    shared,      ///< ranks may use the same CPUs, which are divided among them
    followed,    ///< no two ranks may use the same CPU: MPI bound them, and each has what it is bound to
    overlapping, ///< ranks may use some of the same CPUs; each CPU goes to one of the ranks that may use it
};

/// "unknown", "shared", "followed" or "overlapping".
std::string_view nameOf(CpuChoice choice);

/// Which rank of a machine is to keep which CPUs busy.
struct CpuDivision {
    CpuChoice choice = CpuChoice::unknown;
    std::vector<Cpus> parts{}; ///< by rank of the machine; empty lists for `unknown`
};

/// Divides the CPUs of a machine. No part is empty unless nothing is known: where ranks outnumber CPUs, some share one.
/// @param allowed by rank of the machine, the CPUs that it may use; an empty list where that is not known.
CpuDivision divideCpus(const std::vector<Cpus>& allowed);

} // namespace cdr::ranks
