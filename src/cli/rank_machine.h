#pragma once

#include "shared_options.h"

#include <ranks/ranks.h>

#include <cstdint>
#include <string>

namespace cdr::cli {

/// The device that --device stands for on this rank, as gpu::Device takes it. kEachDevice: the ranks of a machine take its
/// devices in turn, by number. Devices that are processors are taken only if there are no others. Empty, which means the
/// best, if the machine has none.
std::string deviceOf(const std::string& choice, const ranks::Place& place);

/// Where the threads of a rank may run.
enum class ProcessorUse : std::uint8_t {
    free,  ///< on any processor that it was started with
    bound, ///< on its part of them alone
};

/// Divides the processors among the ranks of this machine, as the threads that lavapipe draws with, unless LP_NUM_THREADS
/// says how many. Call it before a Vulkan instance is made.
/// base::RunError where threads are to be bound and cannot be.
void divideProcessors(const ranks::Place& place, ProcessorUse use);

/// "4 ranks, 2 of them on this machine; lavapipe draws with 1 thread in each; they share 2 processors".
/// @param use as divideProcessors() was told.
std::string textOf(const ranks::Place& place, ProcessorUse use);

} // namespace cdr::cli
