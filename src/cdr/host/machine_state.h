#pragma once

#include <optional>
#include <string>

namespace cdr::host {

/// What else decides how long things take here.
struct MachineState {
    std::optional<std::string>
        governor;               ///< that chooses the CPUs' frequency; none where the kernel tells none
    std::optional<double> load; ///< programs that wanted to run, mean of the last minute
};

MachineState machineState();

} // namespace cdr::host
