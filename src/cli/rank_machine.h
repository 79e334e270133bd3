#pragma once

#include <ranks/ranks.h>

#include <string>

namespace cdr::cli {

/// What --device each stands for on this rank: the ranks of a machine take its devices in turn, by number, those that are
/// processors only where there are no others. Empty, for the best, where the machine has none.
std::string dealtDevice(const ranks::Place& place);

/// Divides the processors among the ranks of this machine, as the threads that lavapipe draws with, unless LP_NUM_THREADS
/// says how many. Call it before a Vulkan instance is made.
/// @param bind whether all threads of this rank are to keep to its part of them; base::RunError where they cannot.
void divideProcessors(const ranks::Place& place, bool bind);

/// "4 ranks, 2 of them on this machine; lavapipe draws with 1 thread in each; they share 2 processors".
/// @param bind as divideProcessors() was told.
std::string textOf(const ranks::Place& place, bool bind);

} // namespace cdr::cli
