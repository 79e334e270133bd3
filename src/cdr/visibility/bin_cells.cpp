#include <cdr/visibility/bin_cells.h>
#include <cdr/visibility/box_test.h>
#include <cdr/visibility/landings.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

namespace cdr::visibility {

namespace {

constexpr std::size_t kJobParts = 128;
constexpr std::size_t kJobWords = 1024;

/// With fewer visible than one in so many, sorting them is faster than looking through a bit for every instance.
constexpr std::size_t kFewShare = 8;

/// The cascades that compact instances land in.
struct CellLanding {
    std::size_t first = 0;
    std::size_t end = 0;
};

/// Where instances land whose lower ends lie in `lows` and whose upper ends lie in `highs`; none where they differ,
/// or may.
std::optional<CellLanding> commonLanding(const LandingRanges& ranges, const ViewRange& lows,
                                         const ViewRange& highs) {
    CellLanding landing;
    for (std::size_t c = 0; c < ranges.count; ++c) {
        const bool isBehind = ranges.farView[c] < lows.low;
        const bool isReached = ranges.nearView[c] <= highs.low;
        if ((!isBehind && !(ranges.farView[c] >= lows.high)) ||
            (!isReached && !(ranges.nearView[c] > highs.high))) {
            return std::nullopt;
        }
        landing.first += isBehind ? 1 : 0;
        landing.end += isReached ? 1 : 0;
    }
    const bool isAllCompact = ranges.wideSpan == std::numeric_limits<double>::infinity() ||
                              highs.high - lows.low < ranges.wideSpan * std::max(lows.low, 0.0);
    return isAllCompact ? std::optional(landing) : std::nullopt;
}

/// Puts the instances of cells into `Draws`: InstanceSets or InstanceBags.
template <typename Draws>
class Lander {
  public:
    Lander(const VisibleCells& visible, const LandingRanges& ranges, Draws& draws)
        : m_visible(visible),
          m_ranges(ranges),
          m_boxes(visible.test),
          m_draws(draws) {}

    /// Lands a range of parts. Returns how many instances land anywhere.
    std::size_t land(platform::IndexRange parts) {
        std::size_t landed = 0;
        std::optional<CellLanding> next = landingOf(parts.begin, parts);
        for (std::size_t i = parts.begin; i < parts.end; ++i) {
            const std::optional<CellLanding> landing = next;
            next = landingOf(i + 1, parts);
            const VisibleCells::Part& part = m_visible.parts[i];
            landed += landing ? landAll(part, *landing) : landEach(part);
        }
        return landed;
    }

  private:
    std::optional<CellLanding> boxLanding(std::size_t level, std::size_t node) const {
        const InstanceCells::Box& box = m_visible.cells->levels()[level][node];
        const ViewRange centres = m_boxes.rangeOf(box);
        const double rounding = box.radius * 0x1p-50;
        return commonLanding(m_ranges, {centres.low - box.radius - rounding, centres.high},
                             {centres.low, centres.high + box.radius + rounding});
    }

    /// Where all of a part lands; none where its spheres have to be examined, or behind `parts`.
    std::optional<CellLanding> landingOf(std::size_t part, platform::IndexRange parts) {
        if (part >= parts.end) {
            return std::nullopt;
        }
        const std::size_t cell = m_visible.parts[part].cell;
        const std::size_t parent = cell / InstanceCells::kFan;
        if (parent != m_parent && m_visible.cells->levels().size() > 1) {
            m_parent = parent;
            m_common = boxLanding(1, parent);
        }
        const std::optional<CellLanding> landing = m_common ? m_common : boxLanding(0, cell);
        if (!landing) {
            m_visible.cells->fetchSpheres(cell);
        }
        return landing;
    }

    std::size_t landAll(const VisibleCells::Part& part, const CellLanding& landing) {
        if (landing.first >= landing.end) {
            return 0;
        }
        for (std::size_t c = landing.first; c < landing.end; ++c) {
            m_draws.add(2 * c, m_visible.cells->instancesOf(part.cell), part.slots);
        }
        return static_cast<std::size_t>(std::popcount(part.slots));
    }

    std::size_t landEach(const VisibleCells::Part& part) {
        const Spheres spheres = m_visible.cells->spheres(part.cell);
        const std::uint32_t* const instances = m_visible.cells->instancesOf(part.cell);
        TestedSpheres tested;
        testSpheres(m_visible.test, spheres, InstanceCells::kCellSlots, tested);
        Landings landings;
        findLandings(m_ranges, tested.distanceView.data(), spheres.radius, InstanceCells::kCellSlots,
                     landings);
        std::size_t landed = 0;
        for (std::uint64_t slots = part.slots; slots != 0; slots &= slots - 1) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(slots));
            const auto wide = static_cast<std::size_t>(landings.wide[slot]);
            for (std::int64_t c = landings.first[slot]; c < landings.end[slot]; ++c) {
                m_draws.add(2 * static_cast<std::size_t>(c) + wide, instances[slot]);
            }
            landed += landings.first[slot] < landings.end[slot] ? 1 : 0;
        }
        return landed;
    }

    const VisibleCells& m_visible;
    const LandingRanges& m_ranges;
    BoxTest m_boxes;
    Draws& m_draws;
    std::size_t m_parent = std::numeric_limits<std::size_t>::max(); ///< of the last part's cell
    std::optional<CellLanding> m_common;                            ///< of all that the parent holds
};

/// Lands all that is visible. Returns how many instances land anywhere.
template <typename Draws>
std::size_t landAllParts(const VisibleCells& visible, const LandingRanges& ranges,
                         platform::WorkerPool& workers, std::vector<Draws>& draws) {
    const std::size_t jobs = (visible.parts.size() + kJobParts - 1) / kJobParts;
    std::vector<std::size_t> landed(jobs);
    workers.run(jobs, [&](std::size_t job, std::size_t worker) {
        landed[job] =
            Lander(visible, ranges, draws[worker]).land(platform::evenRange(visible.parts.size(), job, jobs));
    });
    return std::accumulate(landed.begin(), landed.end(), std::size_t{0});
}

} // namespace

void CellBinner::bin(const VisibleCells& visible, const depth::Cascades& clipRanges, double wideSpan,
                     platform::WorkerPool& workers, DrawLists& lists) {
    const LandingRanges ranges(clipRanges, wideSpan);
    if (std::exchange(m_isBinning, true)) { // the last time failed, and left instances in them
        m_sets.clear();
        m_bags.clear();
    }
    if (visible.count() * kFewShare < visible.cells->instances()) {
        binFew(visible, ranges, workers, lists);
    } else {
        binMany(visible, ranges, workers, lists);
    }
    m_isBinning = false;
}

void CellBinner::binMany(const VisibleCells& visible, const LandingRanges& ranges,
                         platform::WorkerPool& workers, DrawLists& lists) {
    m_sets.resize(workers.threads());
    for (InstanceSets& sets : m_sets) {
        const bool hasWide = ranges.wideSpan != std::numeric_limits<double>::infinity();
        sets.resize(2 * ranges.count, hasWide ? 1 : 2, visible.cells->instances());
    }
    lists.visible = landAllParts(visible, ranges, workers, m_sets);
    drain(workers, lists);
}

void CellBinner::drain(platform::WorkerPool& workers, DrawLists& lists) {
    InstanceSets& sets = m_sets.front();
    const std::size_t buckets = sets.buckets();
    const std::size_t jobs = (sets.words() + kJobWords - 1) / kJobWords;
    std::vector<std::size_t> counts(buckets * jobs); // bucket by bucket
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        const platform::IndexRange words = platform::evenRange(sets.words(), job, jobs);
        for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
            for (std::size_t other = 1; other < m_sets.size(); ++other) {
                sets.merge(m_sets[other], bucket, words);
            }
            counts[bucket * jobs + job] = sets.count(bucket, words);
        }
    });
    lists.begins.assign(1, 0);
    std::size_t next = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        for (std::size_t job = 0; job < jobs; ++job) {
            next += std::exchange(counts[bucket * jobs + job], next);
        }
        lists.begins.push_back(next);
    }
    lists.instance.resize(std::max(lists.instance.size(), lists.draws()));
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        const platform::IndexRange words = platform::evenRange(sets.words(), job, jobs);
        for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
            const std::size_t part = bucket * jobs + job;
            const std::size_t end = part + 1 < counts.size() ? counts[part + 1] : lists.draws();
            sets.drain(bucket, words, std::span(lists.instance).subspan(counts[part], end - counts[part]));
        }
    });
}

void CellBinner::binFew(const VisibleCells& visible, const LandingRanges& ranges,
                        platform::WorkerPool& workers, DrawLists& lists) {
    const std::size_t buckets = 2 * ranges.count;
    m_bags.resize(workers.threads());
    for (InstanceBags& bags : m_bags) {
        bags.resize(buckets);
    }
    lists.visible = landAllParts(visible, ranges, workers, m_bags);
    InstanceBags& bags = m_bags.front();
    lists.begins.assign(1, 0);
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        for (std::size_t worker = 1; worker < m_bags.size(); ++worker) {
            bags.merge(m_bags[worker], bucket);
        }
        lists.begins.push_back(lists.draws() + bags.count(bucket));
    }
    lists.instance.resize(std::max(lists.instance.size(), lists.draws()));
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        bags.drain(bucket, visible.cells->instances(), lists.instance.data() + lists.begins[bucket]);
    }
}

} // namespace cdr::visibility
