#include <cdr/host/vector_clones.h>
#include <cdr/visibility/bin.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

namespace cdr::visibility {

namespace {

/// Instances classified together: the working set stays in the first-level cache and the loops over it are
/// vectorised.
constexpr std::size_t kBlock = 256;
constexpr std::size_t kJobInstances = 16'384;

using BucketCounts = std::array<std::size_t, 2 * depth::kMaxCascades>;

/// The ranges as two plain arrays, both ascending, so that the cascades an instance meets are neighbours.
struct Ranges {
    std::array<double, depth::kMaxCascades> nearView{};
    std::array<double, depth::kMaxCascades> farView{};
    std::size_t count = 0;
    double wideSpan = 0.0;

    Ranges(const depth::Cascades& clipRanges, double span) : count(clipRanges.size()), wideSpan(span) {
        double farthest = 0.0;
        for (std::size_t c = 0; c < count; ++c) {
            nearView[c] = clipRanges[c].nearView;
            farthest = std::max(farthest, clipRanges[c].farView);
            farView[c] = farthest;
        }
    }
};

/// Where each instance of a block lands: in the cascades [first, end), none where end <= first.
struct Block {
    std::array<double, kBlock> low;
    std::array<double, kBlock> high;
    // As wide as the numbers they are compared from, so that compilers need not pack them in between.
    std::array<std::int64_t, kBlock> first;
    std::array<std::int64_t, kBlock> end;
    std::array<std::int64_t, kBlock> wide;
};

/// The hot loops: straight-line arithmetic over arrays, no branch, so compilers vectorise them. Adds up the
/// draws per bucket.

CDR_VECTOR_CLONES
void classify(const Ranges& ranges, const VisibleList& visible, std::size_t begin, std::size_t count,
              Block& block, BucketCounts& counts) {
    const double* distanceView = visible.distanceView.data() + begin;
    const float* radius = visible.radius.data() + begin;
    for (std::size_t i = 0; i < count; ++i) {
        const double low = distanceView[i] - static_cast<double>(radius[i]);
        const double high = distanceView[i] + static_cast<double>(radius[i]);
        block.low[i] = low;
        block.high[i] = high;
        // An infinite span times a distance of 0 is not a number, compares false, and so still says compact.
        block.wide[i] = high - low > ranges.wideSpan * std::max(low, 0.0) ? 1 : 0;
        block.first[i] = 0;
        block.end[i] = 0;
    }
    for (std::size_t c = 0; c < ranges.count; ++c) {
        const double farView = ranges.farView[c];
        const double nearView = ranges.nearView[c];
        std::int64_t landed = 0;
        std::int64_t landedWide = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t isBehind = farView < block.low[i] ? 1 : 0;
            const std::int64_t isReached = nearView <= block.high[i] ? 1 : 0;
            const std::int64_t lands = isReached & (1 - isBehind);
            block.first[i] += isBehind;
            block.end[i] += isReached;
            landed += lands;
            landedWide += lands & block.wide[i];
        }
        counts[2 * c] += static_cast<std::size_t>(landed - landedWide);
        counts[2 * c + 1] += static_cast<std::size_t>(landedWide);
    }
}

/// Notes where each instance of a range lands, adds up the draws per bucket, and returns how many land
/// anywhere.
std::size_t countRange(const Ranges& ranges, const VisibleList& visible, host::IndexRange range,
                       BucketCounts& counts, DrawLists& lists) {
    Block block;
    std::size_t landed = 0;
    for (std::size_t begin = range.begin; begin < range.end; begin += kBlock) {
        const std::size_t count = std::min(kBlock, range.end - begin);
        DrawLists::Landing* landings = lists.landings.data() + begin;
        classify(ranges, visible, begin, count, block, counts);
        for (std::size_t i = 0; i < count; ++i) {
            const auto bucket = static_cast<std::uint16_t>(2 * block.first[i] + block.wide[i]);
            const auto cascades =
                static_cast<std::uint16_t>(std::max<std::int64_t>(block.end[i] - block.first[i], 0));
            landings[i] = {.bucket = bucket, .cascades = cascades};
            landed += cascades > 0 ? 1 : 0;
        }
    }
    return landed;
}

void fillRange(const VisibleList& visible, host::IndexRange range, BucketCounts next, DrawLists& lists) {
    std::uint32_t* const instance = lists.instance.data();
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const DrawLists::Landing landing = lists.landings[i];
        for (std::size_t c = 0; c < landing.cascades; ++c) {
            instance[next[landing.bucket + 2 * c]++] = visible.instance[i];
        }
    }
}

/// Turns counts into the first index of each (job, bucket), bucket by bucket, and fills DrawLists::begins.
void layOut(std::vector<BucketCounts>& counts, std::size_t buckets, DrawLists& lists) {
    lists.begins.assign(1, 0);
    std::size_t next = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        for (BucketCounts& job : counts) {
            next += std::exchange(job[bucket], next);
        }
        lists.begins.push_back(next);
    }
}

} // namespace

void binByDistance(const VisibleList& visible, const depth::Cascades& clipRanges, double wideSpan,
                   host::WorkerPool& workers, DrawLists& lists) {
    const Ranges ranges(clipRanges, wideSpan);
    const std::size_t jobs = (visible.count + kJobInstances - 1) / kJobInstances;
    std::vector<BucketCounts> counts(jobs);
    std::vector<std::size_t> landed(jobs);
    lists.landings.resize(std::max(lists.landings.size(), visible.count));
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        landed[job] =
            countRange(ranges, visible, host::evenRange(visible.count, job, jobs), counts[job], lists);
    });
    layOut(counts, 2 * ranges.count, lists);
    lists.visible = std::accumulate(landed.begin(), landed.end(), std::size_t{0});
    lists.instance.resize(std::max(lists.instance.size(), lists.draws()));
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        fillRange(visible, host::evenRange(visible.count, job, jobs), counts[job], lists);
    });
}

} // namespace cdr::visibility
