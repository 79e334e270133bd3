#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/truth.h>
#include <scenes/ladder.h>

#include <cstddef>
#include <optional>

namespace cdr::experiments {

/// The ladder at one distance, as ProbeOptions says. base::InputError unless the distance is from 0.1 to 1e16.
scenes::LadderOptions probeLadder(double distanceView, std::optional<double> nearView = {},
                                  std::optional<double> farView = {});

/// What a picture of the ladder shows. Of surfaces that are not resolved the one with the higher id is visible. So a pair whose
/// front has the higher id is right by luck. Such a pair can fail the test but not pass it.
struct Resolved {
    /// The smallest separation that, with all larger ones, shows no wrong pixel; empty if the largest shows one, or none tells.
    std::optional<double> view;
    /// No separation shows a wrong pixel, so smaller ones than `view` may be resolved too.
    bool all = false;
    /// Pairs of which a pixel tells whether they are resolved: those that are not right by luck. 0: the picture says nothing.
    std::size_t pairsSeen = 0;
};

/// @param ids object index + 1, of a picture of `truth`'s size.
Resolved resolvedIn(const image::ImageU32& ids, const measure::TruthImage& truth,
                    const scenes::LadderOptions& ladder);

} // namespace cdr::experiments
