#pragma once

#include <string>
#include <vector>

namespace cdr::test {

/// All of this program calls Vulkan by a loader of its own, as a host may bring one. It returns what the system's loader
/// returns, except for the features that a test withholds here, by their names in Vulkan.
std::vector<std::string>& withheldFeatures();

} // namespace cdr::test
