#pragma once

#include <string>
#include <vector>

namespace cdr::test {

/// All of this program calls Vulkan by a loader of its own, as a host may bring one. It returns what the system's loader
/// returns, except for the features that a test withholds here, by their names in Vulkan.
std::vector<std::string>& withheldFeatures();

/// What this program's waits come to.
struct Waits {
    int fencesToFail = 0; ///< so many of the next waits for fences end with an error
    int idle = 0;         ///< calls of vkQueueWaitIdle()
};
Waits& waits();

} // namespace cdr::test
