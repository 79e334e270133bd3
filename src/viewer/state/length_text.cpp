#include "length_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace cdr::viewer {

namespace {

struct Unit {
    double metres;
    std::string_view name;
};
constexpr std::array<Unit, 5> kUnits{
    {{1e-6, "µm"}, {1e-3, "mm"}, {1.0, "m"}, {1e3, "km"}, {1e9, "million\u00a0km"}}};

/// The largest unit that the length fills.
const Unit& unitOf(double metres) {
    const auto larger = std::find_if(kUnits.begin() + 1, kUnits.end(),
                                     [&](const Unit& unit) { return unit.metres > std::abs(metres); });
    return *std::prev(larger);
}

/// Power of ten of the first digit.
int placeOf(double value) {
    return static_cast<int>(std::floor(std::log10(value)));
}

/// What a float64 holds.
constexpr int kMostDigits = 17;
constexpr int kDigitsWithoutStep = 4;

} // namespace

std::string lengthText(double metres, double stepMetres) {
    if (!std::isfinite(metres)) {
        return "infinite";
    }
    const bool hasStep = std::isfinite(stepMetres) && stepMetres > 0.0;
    if (metres == 0.0 || (hasStep && std::abs(metres) < 0.5 * stepMetres)) {
        return fmt::format("0\u00a0{}", unitOf(hasStep ? stepMetres : 1.0).name);
    }
    const Unit& unit = unitOf(metres);
    const double value = metres / unit.metres;
    const int first = placeOf(std::abs(value));
    const int last = hasStep ? placeOf(stepMetres / unit.metres) : first - kDigitsWithoutStep + 1;
    const int decimals = std::clamp(-last, 0, std::max(0, kMostDigits - 1 - first));
    return fmt::format("{:.{}f}\u00a0{}", value, decimals, unit.name);
}

std::string counted(std::uint64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string lagText(double seconds) {
    constexpr double kNoticed = 0.5;
    return seconds < kNoticed ? "" : fmt::format("rendering, {:.1f}\u00a0s behind", seconds);
}

std::string stepText(double metres) {
    if (!std::isfinite(metres)) {
        return "infinite";
    }
    // Below that, zeros would be all there is to see.
    constexpr double kSmallest = 1e-10;
    if (std::abs(metres) < kSmallest) {
        return metres == 0.0 ? "0\u00a0µm" : fmt::format("{:.1e}\u00a0m", metres);
    }
    const Unit& unit = unitOf(metres);
    const double value = metres / unit.metres;
    return fmt::format("{:.{}f}\u00a0{}", value, std::max(0, 1 - placeOf(std::abs(value))), unit.name);
}

} // namespace cdr::viewer
