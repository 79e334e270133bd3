#pragma once

#include <cstdint>
#include <optional>

namespace cdr::measure {

/// A count over all; nothing where there are none to judge by.
inline std::optional<double> shareOf(std::uint64_t part, std::uint64_t all) {
    return all > 0 ? std::optional(static_cast<double>(part) / static_cast<double>(all)) : std::nullopt;
}

} // namespace cdr::measure
