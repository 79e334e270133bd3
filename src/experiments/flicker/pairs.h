#pragma once

#include "flicker.h"

#include <cdr/measure/statistics/choice_statistics.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::experiments {

/// One of the thesis' six videos: two techniques side by side (Table 6.1). Twelve people chose the one that
/// flickers less (Tables 6.3 to 6.8).
struct ThesisPair {
    std::string_view left;
    std::string_view right;
    measure::ChoiceCounts humans;
};
inline constexpr std::array<ThesisPair, 6> kThesisPairs{{{"standard", "cdr", {2, 10}},
                                                         {"cdr", "log", {0, 12}},
                                                         {"standard", "logcdr", {0, 12}},
                                                         {"standard", "log", {0, 12}},
                                                         {"cdr", "logcdr", {0, 12}},
                                                         {"log", "logcdr", {1, 11}}}};

enum class Side { left, right };

/// A pair, its flips, and what an ideal observer makes of them.
struct FlickerPair {
    std::string left;
    std::string right;
    measure::FlipCount flipsLeft;
    measure::FlipCount flipsRight;
    /// The side with fewer flips; empty when they have as many, or when nothing could flip.
    std::optional<Side> observer;
    measure::ChoiceCounts humans;

    Side humansChoice() const { return humans.left > humans.right ? Side::left : Side::right; }
    /// Whether both sides have pixels that could flip; else there is no verdict.
    bool couldJudge() const { return flipsLeft.compared > 0 && flipsRight.compared > 0; }
    /// Of a pair that could be judged.
    bool agree() const { return observer == humansChoice(); }
    double chiSquared() const { return measure::chiSquared(humans); }
    double binomialP() const { return measure::binomialTail(humans); }
};

/// The thesis' pairs of which both sides are among the results, in its order.
std::vector<FlickerPair> comparePairs(const std::vector<FlickerResult>& results);

} // namespace cdr::experiments
