#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/base/result.h>
#include <cdr/depth/format.h>
#include <cdr/depth/mapping.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace cdr::depth {

/// The view-distance gap beyond `distanceView` over which a depth buffer of this format moves by one step.
/// The buffer alone resolves this; vertices round as well. Not to first order, but by the spacing just below the depth of the
/// distance. At a power of two the spacing above is twice that. The mapping goes on beyond a closed far
/// plane, so the gap may end there. Infinity where all that is farther lies within one step.
CDR_EXPORT double separationView(const DepthRange& range, DepthFormat format, double distanceView);

/// The same in the cascade that holds `distanceView`; ranges do not overlap. Infinity outside all of them.
CDR_EXPORT double separationView(Mapping mapping, const Cascades& cascades, DepthFormat format,
                                 double distanceView);

/// The formulas of the thesis (Listing A.2) for an integer buffer. Standard is Baker 1999 with 2^bits steps,
/// log is Ulrich 2011 with 2^bits - 1 steps. Baker measures towards the camera and separationView() away from
/// it, so they differ where a step spans a large share of the distance.
/// @param mapping standard or log.
/// @throws base::InputError for another mapping, which the thesis does not have.
CDR_EXPORT double thesisSeparationView(Mapping mapping, const Cascades& cascades, int bits,
                                       double distanceView);
/// The same, refused instead of thrown.
CDR_EXPORT base::Result<double> tryThesisSeparationView(Mapping mapping, const Cascades& cascades, int bits,
                                                        double distanceView);

/// Where a separation curve over view distance meets a value.
struct Crossing {
    /// The first distance at which the separation reaches the value: the thesis' Table 4.1.
    double reachedFirstView = 0.0;
    /// The last distance at which the separation is still below the value. With cascades the curve falls at
    /// each boundary, so this may lie beyond the first.
    double heldLastView = 0.0;
};

/// Finds both crossings of `curve` with `separation` on [nearView, farView], by a logarithmic scan and
/// bisection. Empty when the curve never reaches the value.
/// @param curve separations by view distance, both in scene units; called about 200,000 times.
/// @errors What `curve` throws.
CDR_EXPORT std::optional<Crossing> findCrossing(const std::function<double(double)>& curve, double separation,
                                                double nearView, double farView);
/// The same for each of several separations, in their order, by one scan.
/// @units Scene units, view distances.
/// @errors What `curve` throws.
CDR_EXPORT std::vector<std::optional<Crossing>> findCrossings(const std::function<double(double)>& curve,
                                                              std::span<const double> separations,
                                                              double nearView, double farView);

} // namespace cdr::depth
