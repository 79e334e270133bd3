#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace cdr::program {

/// What else decides how long things take here.
struct MachineState {
    std::optional<std::string>
        governor;               ///< that chooses the CPUs' frequency; none where the kernel tells none
    std::optional<double> load; ///< programs that wanted to run, mean of the last minute
    std::size_t cpus = 1;       ///< that are there, though this process may not use all

    /// Whether other programs took more than half of the machine.
    bool isBusy() const { return load.value_or(0.0) > 0.5 * static_cast<double>(cpus); }
};

MachineState machineState();

} // namespace cdr::program
