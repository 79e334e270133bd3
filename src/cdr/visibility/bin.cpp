#include <cdr/visibility/bin.h>
#include <cdr/visibility/landings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace cdr::visibility {

namespace {

constexpr std::size_t kJobInstances = 16'384;

using BucketCounts = std::array<std::size_t, 2 * depth::kMaxCascades>;

/// Notes where each instance of a range lands, adds up the draws per bucket, and returns how many land
/// anywhere.
std::size_t countRange(const LandingRanges& ranges, const VisibleList& visible, platform::IndexRange range,
                       BucketCounts& counts, DrawLists& lists) {
    Landings landings;
    std::size_t landed = 0;
    for (std::size_t begin = range.begin; begin < range.end; begin += kLandingBlock) {
        const std::size_t count = std::min(kLandingBlock, range.end - begin);
        findLandings(ranges, visible.distanceView.data() + begin, visible.radius.data() + begin, count,
                     landings);
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t cascades = std::max<std::int64_t>(landings.end[i] - landings.first[i], 0);
            const auto bucket = static_cast<std::size_t>(2 * landings.first[i] + landings.wide[i]);
            for (std::size_t c = 0; c < static_cast<std::size_t>(cascades); ++c) {
                ++counts[bucket + 2 * c];
            }
            lists.landings[begin + i] = {.bucket = static_cast<std::uint16_t>(bucket),
                                         .cascades = static_cast<std::uint16_t>(cascades)};
            landed += cascades > 0 ? 1 : 0;
        }
    }
    return landed;
}

void fillRange(const VisibleList& visible, platform::IndexRange range, BucketCounts next, DrawLists& lists) {
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

void keepCascades(DrawLists& lists, platform::IndexRange cascades) {
    const std::size_t first = lists.begins[2 * cascades.begin];
    const std::size_t last = lists.begins[2 * cascades.end];
    const auto entries = lists.instance.begin();
    std::copy(entries + static_cast<std::ptrdiff_t>(first), entries + static_cast<std::ptrdiff_t>(last),
              entries);
    for (std::size_t& begin : lists.begins) {
        begin = std::clamp(begin, first, last) - first;
    }
}

void binByDistance(const VisibleList& visible, const depth::Cascades& clipRanges, double wideSpan,
                   platform::WorkerPool& workers, DrawLists& lists) {
    const LandingRanges ranges(clipRanges, wideSpan);
    const std::size_t jobs = (visible.count + kJobInstances - 1) / kJobInstances;
    std::vector<BucketCounts> counts(jobs);
    std::vector<std::size_t> landed(jobs);
    lists.landings.resize(std::max(lists.landings.size(), visible.count));
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        landed[job] =
            countRange(ranges, visible, platform::evenRange(visible.count, job, jobs), counts[job], lists);
    });
    layOut(counts, 2 * ranges.count, lists);
    lists.visible = std::accumulate(landed.begin(), landed.end(), std::size_t{0});
    lists.instance.resize(std::max(lists.instance.size(), lists.draws()));
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        fillRange(visible, platform::evenRange(visible.count, job, jobs), counts[job], lists);
    });
}

} // namespace cdr::visibility
