#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/truth.h>
#include <scenes/ladder.h>

#include <optional>

namespace cdr::experiments {

/// The ladder at one distance, as ProbeOptions says. base::InputError for a distance that is too short or not finite.
scenes::LadderOptions probeLadder(double distanceView, std::optional<double> nearView = {},
                                  std::optional<double> farView = {});

/// The smallest separation that, with all larger ones, shows no wrong pixel; empty if the largest shows one. Of surfaces that
/// are not resolved the one with the higher id is visible. So a pair whose front has the higher id is right by luck. Such a
/// pair can fail the test but not pass it.
/// @param ids object index + 1, of a picture of `truth`'s size.
std::optional<double> smallestResolved(const image::ImageU32& ids, const measure::TruthImage& truth,
                                       const scenes::LadderOptions& ladder);

/// Whether no separation shows a wrong pixel: then smaller ones than smallestResolved() may be resolved too.
/// @param ids as above.
bool resolvesAll(const image::ImageU32& ids, const measure::TruthImage& truth,
                 const scenes::LadderOptions& ladder);

} // namespace cdr::experiments
