#pragma once

#include <cdr/gpu/device.h>
#include <cdr/image/picture_size.h>
#include <cdr/measure/statistics/statistics.h>
#include <experiments/progress.h>

#include <output/columns.h>
#include <ranks/ranks.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::experiments {

/// How a frame's cascades scale with the ranks that draw them: unit cubes all in view, in targets `layers`.
struct RankSweepOptions {
    std::vector<image::PictureSize> sizes{{640, 360}, {1280, 720}};
    std::vector<unsigned> cascades{1, 4, 8};
    std::uint32_t cubes = 10'000;
    std::uint32_t repeats = 7; ///< timed frames of each point, after one that warms up
    std::uint64_t seed = 2013;
};

/// base::InputError for an empty list or a value out of range.
void requireUsable(const RankSweepOptions& options);

/// What one rank did of a point.
struct RankShare {
    std::size_t rank = 0;
    double drawMs = 0.0;           ///< median, its own cascades, read-back included
    std::size_t bytesSent = 0;     ///< a frame
    std::uint64_t deviceBytes = 0; ///< for its part of the scene, and its images
};

/// One (size, cascades, ranks). Ratios are over one rank, repeat by repeat.
struct RankPoint {
    image::PictureSize size;
    unsigned cascades = 1;
    std::size_t ranks = 1;
    double frameMs = 0.0; ///< median, from the start until the first rank has the frame
    std::optional<measure::Interval> frameInterval{};
    double speedUp = 1.0;
    std::optional<measure::Interval> speedUpInterval{};
    std::vector<RankShare> shares; ///< by rank
    bool sameImage = true;         ///< as of one rank

    double efficiency() const { return speedUp / static_cast<double>(ranks); }
    std::size_t bytesSent() const;         ///< a frame, by all ranks
    double slowestDrawMs() const;          ///< of the ranks' medians
    std::uint64_t mostDeviceBytes() const; ///< of a rank
};

/// 1, 2, 4, ... and `count`.
std::vector<std::size_t> rankSteps(std::size_t count);

/// All ranks call it. The points are the first rank's; those of the others are empty.
std::vector<RankPoint> runRankSweep(const gpu::Device& device, const RankSweepOptions& options,
                                    ranks::Ranks& ranks, const NamedProgress& progress);

output::Columns<RankPoint> rankPointColumns();

} // namespace cdr::experiments
