#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <optional>
#include <string>

namespace cdr::test {

/// This program calls Vulkan by a loader of its own, which counts the barriers that are recorded. One of them it records
/// without stages and accesses: it still changes layouts, but nothing waits for anything.
class WeakenedBarriers {
  public:
    /// Counts from 0 on again. The barrier of that number is weakened; without one, none is.
    static void begin(std::optional<std::size_t> weakened);
    /// Barriers since begin().
    static std::size_t counted();
    /// What the weakened barrier was, in Vulkan's words. Empty: none was weakened.
    static const std::string& weakened();
};

} // namespace cdr::test
