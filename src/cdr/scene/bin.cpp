#include <cdr/scene/bin.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cdr::scene {

namespace {

constexpr std::size_t kJobInstances = 16'384;

using BucketCounts = std::array<std::size_t, 2 * depth::kMaxCascades>;

/// The ranges as two plain arrays.
struct Ranges {
    std::array<double, depth::kMaxCascades> nearView{};
    std::array<double, depth::kMaxCascades> farView{};
    std::size_t count = 0;
    double wideSpan = 0.0;

    Ranges(const depth::Cascades& clipRanges, double span) : count(clipRanges.size()), wideSpan(span) {
        for (std::size_t c = 0; c < count; ++c) {
            nearView[c] = clipRanges[c].nearView;
            farView[c] = clipRanges[c].farView;
        }
    }
};

/// Calls `visit(bucket, visible index)` for every cascade an instance meets; instances ascend, and cascades
/// in each.
template <typename Visit>
void forEachMeeting(const Ranges& ranges, const VisibleList& visible, base::IndexRange range, Visit&& visit) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const double low = visible.distanceView[i] - static_cast<double>(visible.radius[i]);
        const double high = visible.distanceView[i] + static_cast<double>(visible.radius[i]);
        // An infinite span times a distance of 0 is not a number, compares false, and so still says compact.
        const std::size_t wide = high - low > ranges.wideSpan * std::max(low, 0.0) ? 1 : 0;
        for (std::size_t c = 0; c < ranges.count; ++c) {
            if (low <= ranges.farView[c] && high >= ranges.nearView[c]) {
                visit(2 * c + wide, i);
            }
        }
    }
}

/// How many draws each (job, bucket) adds, and in `seen` how many instances land anywhere.
void countJobs(const Ranges& ranges, const VisibleList& visible, base::WorkerPool& workers,
               std::vector<BucketCounts>& counts, std::vector<std::size_t>& seen) {
    const std::size_t jobs = counts.size();
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        BucketCounts mine{};
        std::size_t landed = 0;
        std::size_t previous = static_cast<std::size_t>(-1);
        forEachMeeting(ranges, visible, base::evenRange(visible.count, job, jobs),
                       [&](std::size_t bucket, std::size_t i) {
                           ++mine[bucket];
                           landed += i != previous ? 1 : 0;
                           previous = i;
                       });
        counts[job] = mine;
        seen[job] = landed;
    });
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
                   base::WorkerPool& workers, DrawLists& lists) {
    const Ranges ranges(clipRanges, wideSpan);
    const std::size_t jobs = (visible.count + kJobInstances - 1) / kJobInstances;
    std::vector<BucketCounts> counts(jobs);
    std::vector<std::size_t> seen(jobs);
    countJobs(ranges, visible, workers, counts, seen);
    layOut(counts, 2 * ranges.count, lists);
    lists.visible = 0;
    for (const std::size_t landed : seen) {
        lists.visible += landed;
    }
    lists.instance.resize(std::max(lists.instance.size(), lists.draws()));
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        BucketCounts next = counts[job];
        forEachMeeting(
            ranges, visible, base::evenRange(visible.count, job, jobs),
            [&](std::size_t bucket, std::size_t i) { lists.instance[next[bucket]++] = visible.instance[i]; });
    });
}

} // namespace cdr::scene
