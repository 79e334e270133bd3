#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/render/render_options.h>
#include <experiments/progress.h>

#include <ranks/ranks.h>
#include <rivals/rival.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// Smallest resolved separation, measured on the ladder scene (thesis chapter 7: formulas "are not reliable
/// in practice").
///
/// Near is 0.001 and far twice the distance unless given. The field is 32 units deep and wide. So below 1000
/// units all of it shrinks, cubes, grid and separations alike, to a thousandth of the distance per unit.
struct ProbeOptions {
    std::vector<double> distancesView{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
    std::vector<depth::NamedTechnique> techniques{depth::presets().begin(), depth::presets().end()};
    std::vector<rivals::NamedRival> rivalsBeside{}; ///< measured as the techniques are, behind them
    std::optional<double> nearView;
    std::optional<double>
        farView; ///< at least 1.02 times the distance is taken, so that the field is before it
    std::vector<depth::DepthFormat> formats; ///< all that the device can draw to when empty
    render::RenderOptions drawing{};         ///< but for the technique; rivals are not snapped
    std::uint64_t seed = 2013;
};

/// One technique and format, or one rival, at one distance.
struct ProbeResult {
    std::string technique;
    std::optional<depth::DepthFormat> format; ///< none for a rival, which has keys of 64 bits
    double distanceView = 0.0;
    /// The smallest separation that, with all larger ones, shows no wrong pixel; empty when the largest does, or none is seen.
    std::optional<double> resolvedView;
    bool resolvesAll = false;    ///< no separation of the ladder shows one, so less may be resolved
    std::size_t pairsSeen = 0;   ///< pairs of which a pixel tells: of 0 the picture is too small
    double predictedView = 0.0;  ///< depth::forecast(); NaN for a rival, which it does not know
    double guaranteedView = 0.0; ///< the same with every rounding at its worst
    double smallestView = 0.0;   ///< of the ladder: `resolved` can be no less
    double largestView = 0.0;    ///< of the ladder: null means more than this
    std::size_t cascades = 0;

    bool isRival() const { return !format; }
};

/// Distances are units of the ranks. The first rank has the results, others an empty list. base::InputError for an
/// unusable distance, and for a depth format or a rival that the device cannot draw.
std::vector<ProbeResult> runProbe(const gpu::Device& device, const ProbeOptions& options,
                                  const NamedProgress& progress, ranks::Ranks& ranks);

} // namespace cdr::experiments
