#include <cdr/image/srgb.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cdr::image {

namespace {

double linearOf(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

/// Linear light at which each 8-bit value but the first begins to be the nearest.
const std::array<double, 255>& thresholds() {
    static const std::array<double, 255> kTable = [] {
        std::array<double, 255> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            table[i] = linearOf((static_cast<double>(i) + 0.5) / 255.0);
        }
        return table;
    }();
    return kTable;
}

} // namespace

const std::array<double, 256>& linearOfSrgb() {
    static const std::array<double, 256> kTable = [] {
        std::array<double, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            table[i] = linearOf(static_cast<double>(i) / 255.0);
        }
        return table;
    }();
    return kTable;
}

std::uint8_t srgbOfLinear(double linear) {
    const auto& starts = thresholds();
    return static_cast<std::uint8_t>(std::upper_bound(starts.begin(), starts.end(), linear) - starts.begin());
}

} // namespace cdr::image
