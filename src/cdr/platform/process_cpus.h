#pragma once

#include <cstddef>
#include <vector>

namespace cdr::platform {

/// CPUs that the process that started this one may run on, ascending: a launcher of MPI binds those it starts, and not itself.
/// Empty where the system cannot tell.
std::vector<std::size_t> cpusOfParent();

/// Lets the calling thread, and threads and processes that it starts from now on, run on these CPUs alone. Without CPUs, and
/// where the system has no such call, nothing happens. Where one of them is not there, the thread keeps those that it had or
/// has the others.
void allowCpus(const std::vector<std::size_t>& cpus);

} // namespace cdr::platform
