#include "resolved.h"

#include <cdr/base/format_error.h>
#include <cdr/measure/compare/wrong_pixels.h>

#include <algorithm>
#include <array>

namespace cdr::experiments {

namespace {

std::uint32_t pairOf(std::uint32_t id) {
    return (id - 1) / 2;
}

/// Whether a pixel shows if a pair is resolved. It must be off silhouettes and show both objects of the pair, one
/// behind the other. They must not be so close together that they are sides in one plane.
bool tells(const measure::TruthPixel& pixel, bool inner, const scenes::LadderOptions& ladder) {
    if (!inner || pixel.secondId == 0 || pairOf(pixel.id) != pairOf(pixel.secondId)) {
        return false;
    }
    const double separation = scenes::ladderSeparation(ladder, pairOf(pixel.id));
    return pixel.gapView() >= 0.5 * separation;
}

/// By pair.
struct Rungs {
    std::array<bool, scenes::kLadderPairs> lucky; ///< it is right by luck, or no pixel shows it
    std::array<bool, scenes::kLadderPairs> wrong; ///< it shows a wrong pixel
};

Rungs judged(const image::ImageU32& ids, const measure::TruthImage& truth,
             const scenes::LadderOptions& ladder) {
    const auto inner = measure::innerMask(truth);
    Rungs rungs{};
    rungs.lucky.fill(true); // a pair that no pixel shows does not pass either
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const measure::TruthPixel& pixel = truth.pixels[i];
        if (tells(pixel, inner.pixels[i] != 0, ladder)) {
            rungs.lucky[pairOf(pixel.id)] = pixel.id > pixel.secondId;
            rungs.wrong[pairOf(pixel.id)] |= ids.pixels[i] != pixel.id;
        }
    }
    return rungs;
}

} // namespace

scenes::LadderOptions probeLadder(double distanceView, std::optional<double> nearView,
                                  std::optional<double> farView) {
    // Beyond, float64 has no place for the ladder's cubes. NaN is refused too.
    if (!(distanceView >= 0.1 && distanceView <= 1e16)) {
        throw base::inputError("a probe's distance must be from 0.1 to 1e16, not {}", distanceView);
    }
    return {.distanceView = distanceView,
            .nearView = nearView.value_or(0.001),
            .farView = std::max(farView.value_or(2.0 * distanceView), 1.02 * distanceView),
            .scale = std::min(1.0, distanceView / 1000.0)};
}

Resolved resolvedIn(const image::ImageU32& ids, const measure::TruthImage& truth,
                    const scenes::LadderOptions& ladder) {
    const Rungs rungs = judged(ids, truth, ladder);
    Resolved resolved{.view = std::nullopt, .all = true};
    for (std::uint32_t pair = scenes::kLadderPairs; pair-- > 0;) {
        resolved.all = resolved.all && !rungs.wrong[pair];
        resolved.pairsSeen += rungs.wrong[pair] || !rungs.lucky[pair] ? 1 : 0;
        if (resolved.all && !rungs.lucky[pair]) {
            resolved.view = scenes::ladderSeparation(ladder, pair);
        }
    }
    return resolved;
}

} // namespace cdr::experiments
