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

/// How many thresholds lie at or below i / kBins: where the search for a value between begins.
constexpr std::size_t kBins = 4096;
const std::array<std::uint8_t, kBins>& firstGuesses() {
    static const std::array<std::uint8_t, kBins> kTable = [] {
        const auto& starts = thresholds();
        std::array<std::uint8_t, kBins> table{};
        for (std::size_t i = 0; i < kBins; ++i) {
            const double linear = static_cast<double>(i) / static_cast<double>(kBins);
            table[i] = static_cast<std::uint8_t>(std::ranges::upper_bound(starts, linear) - starts.begin());
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
    if (!(linear < 1.0)) {
        return 255;
    }
    if (linear <= 0.0) {
        return 0;
    }
    const auto& starts = thresholds();
    std::size_t value = firstGuesses()[static_cast<std::size_t>(linear * static_cast<double>(kBins))];
    while (value < starts.size() && starts[value] <= linear) {
        ++value;
    }
    return static_cast<std::uint8_t>(value);
}

} // namespace cdr::image
