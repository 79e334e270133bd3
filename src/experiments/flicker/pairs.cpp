#include "pairs.h"

#include <algorithm>

namespace cdr::experiments {

namespace {

std::optional<Side> steadier(const measure::FlipCount& left, const measure::FlipCount& right) {
    if (left.compared == 0 || right.compared == 0 || left.flips == right.flips) {
        return std::nullopt;
    }
    return left.flips < right.flips ? Side::left : Side::right;
}

} // namespace

std::vector<FlickerPair> comparePairs(const std::vector<FlickerResult>& results) {
    const auto find = [&](std::string_view technique) {
        return std::find_if(results.begin(), results.end(),
                            [&](const FlickerResult& result) { return result.technique == technique; });
    };
    std::vector<FlickerPair> pairs;
    for (const ThesisPair& pair : kThesisPairs) {
        const auto left = find(pair.left);
        const auto right = find(pair.right);
        if (left != results.end() && right != results.end()) {
            pairs.push_back({.left = left->technique,
                             .right = right->technique,
                             .flipsLeft = left->flips,
                             .flipsRight = right->flips,
                             .observer = steadier(left->flips, right->flips),
                             .humans = pair.humans});
        }
    }
    return pairs;
}

} // namespace cdr::experiments
