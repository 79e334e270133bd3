#pragma once

#include <output/columns.h>
#include <rivals/contender.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cdr::experiments {

/// What one contender needs.
struct RivalNeeds {
    std::string contender;
    std::uint32_t geometryPasses = 1;
    std::uint32_t bytesPerPixel = 0;
    std::vector<std::string> features; ///< of Vulkan, beyond those that cdr needs anyway
};

/// @param name as it was asked for.
RivalNeeds needsOf(const std::string& name, const rivals::Competing& competing);

output::Columns<RivalNeeds> rivalNeedsColumns();

} // namespace cdr::experiments
