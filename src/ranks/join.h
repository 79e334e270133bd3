#pragma once

#include <ranks/ranks.h>

#include <memory>
#include <string>

namespace cdr::ranks {

/// The ranks of the run that this process is a part of, if mpirun, mpiexec or srun started it. Else it is alone. Once
/// per process, from main().
/// @param explain what the error of a rank's unit is to the first rank.
/// @param say how the process is told that a rank was killed, or that a signal ends the run.
/// base::InputError where it was started as one of several and the program was built without MPI.
std::unique_ptr<Run> join(Explain explain, Say say);

/// The MPI library that the program was built with, such as "Open MPI v4.1.4"; empty for none.
std::string mpiLibrary();

} // namespace cdr::ranks
