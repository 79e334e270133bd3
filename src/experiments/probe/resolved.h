#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/truth.h>
#include <scenes/ladder.h>

#include <optional>

namespace cdr::experiments {

/// The ladder as it stands at one distance, as ProbeOptions says. base::InputError for a distance that is too short or not
/// finite.
scenes::LadderOptions probeLadder(double distanceView, std::optional<double> nearView = {},
                                  std::optional<double> farView = {});

/// The smallest separation that, with all larger ones, shows no wrong pixel; empty when the largest does. Of surfaces that
/// cannot be told apart the one of the higher id shows. So a pair whose front has it comes out right by luck: it can fail
/// the test but not pass it.
/// @param ids object index + 1, of a picture of `truth`'s size.
std::optional<double> smallestResolved(const image::ImageU32& ids, const measure::TruthImage& truth,
                                       const scenes::LadderOptions& ladder);

/// Whether no separation shows a wrong pixel: then smaller ones than smallestResolved() may be resolved too.
/// @param ids as above.
bool resolvesAll(const image::ImageU32& ids, const measure::TruthImage& truth,
                 const scenes::LadderOptions& ladder);

} // namespace cdr::experiments
