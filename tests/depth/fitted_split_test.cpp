#include "random_ranges.h"

#include <cdr/depth/cascade_plan.h>
#include <cdr/depth/fitted_split.h>
#include <cdr/depth/make_cascades.h>
#include <cdr/depth/separation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace cdr::depth;
using cdr::test::RandomRanges;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

SplitContext viewOf(Mapping mapping, DepthFormat format = DepthFormat::d32f) {
    return {.nearView = 0.1, .farView = 1e6, .model = {mapping, format}, .footprintSlope = 0.0016};
}

Cascades fit(const SplitFitted& split, SplitContext view, std::vector<Interval> intervals,
             const Cascades& previous = {}) {
    view.visible = intervals;
    view.previous = previous;
    return makeCascades(split, view);
}

/// Every occupied distance lies in a cascade, cascades ascend, and none is empty.
void expectCovers(const Cascades& cascades, const SplitContext& view,
                  const std::vector<Interval>& intervals) {
    ASSERT_FALSE(cascades.empty());
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        EXPECT_LT(cascades[i].nearView, cascades[i].farView);
        EXPECT_GE(cascades[i].nearView, view.nearView);
        EXPECT_LE(cascades[i].farView, view.farView);
        if (i > 0) {
            EXPECT_GE(cascades[i].nearView, cascades[i - 1].farView);
        }
    }
    for (const Interval& interval : intervals) {
        const double low = std::max(interval.nearView, view.nearView);
        const double high = std::min(interval.farView, view.farView);
        for (int i = 0; low <= high && i <= 8; ++i) {
            const double w = low + (high - low) * i / 8.0;
            EXPECT_TRUE(std::any_of(cascades.begin(), cascades.end(), [&](const Cascade& c) {
                return w >= c.nearView && w <= c.farView;
            })) << w;
        }
    }
}

double worstShare(const Cascades& cascades, const SplitContext& view, double target) {
    double worst = 0.0;
    for (const Cascade& cascade : cascades) {
        worst = std::max(worst, worstStepShare(view.model,
                                               {.shareView = target * view.footprintSlope,
                                                .leastShareView = distanceRounding(view.model.mapping)},
                                               cascade));
    }
    return worst;
}

class FitOfEveryMapping : public testing::TestWithParam<Mapping> {};

TEST_P(FitOfEveryMapping, StepBoundNeverFallsAsTheCascadeGrows) {
    RandomRanges random(3);
    for (int i = 0; i < 20'000; ++i) {
        const double n = random.logUniform(0.01, 100.0);
        const double f = n * (1.0 + random.logUniform(1e-4, 1e5));
        const double w = random.uniform(n, f);
        const Cascade larger{n * random.uniform(0.5, 1.0), f * random.uniform(1.0, 2.0)};
        for (const DepthFormat format : kDepthFormats) {
            const StepModel model{GetParam(), format};
            EXPECT_LE(stepBoundView(model, {n, f}, w), stepBoundView(model, larger, w) * (1.0 + 1e-12));
        }
    }
}

TEST_P(FitOfEveryMapping, StepBoundBoundsTheSeparationAndWorstBoundsTheSteps) {
    RandomRanges random(4);
    for (int i = 0; i < 5000; ++i) {
        const double n = random.logUniform(0.01, 100.0);
        const Cascade cascade{n, n * (1.0 + random.logUniform(1e-3, 1e3))};
        for (const DepthFormat format : kDepthFormats) {
            const StepModel model{GetParam(), format};
            const StepTarget target{.unitsView = random.logUniform(1e-9, 1.0),
                                    .shareView = i % 2 ? 0.0 : random.logUniform(1e-9, 1e-3),
                                    .leastShareView = i % 3 ? 0.0 : 0x1p-24};
            const double worst = worstStepShare(model, target, cascade);
            for (int k = 0; k <= 20; ++k) {
                const double w = n + (cascade.farView - n) * k / 20.0;
                const double bound = stepBoundView(model, cascade, w);
                EXPECT_LE(bound / target.at(w), worst * (1.0 + 1e-12));
                const double exact =
                    separationView({GetParam(), cascade.nearView, cascade.farView}, format, w);
                if (exact < 0.01 * w && exact > 1e-18 * w) { // not where depth is 0
                    EXPECT_LE(exact, bound * 1.02) << nameOf(format) << " " << w;
                    EXPECT_GE(bound, 0.4 * exact);
                }
            }
        }
    }
}

/// The fewest cascades, and then the fewest cuts, by dynamic programming over a fine grid and all interval
/// ends.
struct BruteForce {
    std::size_t cascades = 0;
    std::size_t cuts = 0;
};
BruteForce bruteForce(const StepModel& model, const StepTarget& target,
                      const std::vector<Interval>& occupied) {
    constexpr int kGrid = 60;
    struct Place {
        double beginView; ///< where a cascade that starts here begins
        double endView;   ///< where the one before may end
        bool isCut;
    };
    std::vector<Place> places;
    for (std::size_t j = 0; j < occupied.size(); ++j) {
        const Interval& o = occupied[j];
        places.push_back({o.nearView, j ? occupied[j - 1].farView : o.nearView, false});
        for (int i = 1; i < kGrid; ++i) {
            const double w = o.nearView * std::pow(o.farView / o.nearView, static_cast<double>(i) / kGrid);
            places.push_back({w, w, true});
        }
    }
    places.push_back({kNan, occupied.back().farView, false});
    std::vector<BruteForce> best(places.size(), {1000, 1000});
    best[0] = {0, 0};
    for (std::size_t to = 1; to < places.size(); ++to) {
        for (std::size_t from = 0; from < to; ++from) {
            const BruteForce with{best[from].cascades + 1, best[from].cuts + (places[to].isCut ? 1 : 0)};
            const bool better = with.cascades < best[to].cascades ||
                                (with.cascades == best[to].cascades && with.cuts < best[to].cuts);
            if (better &&
                worstStepShare(model, target, {places[from].beginView, places[to].endView}) <= 1.0) {
                best[to] = with;
            }
        }
    }
    return best.back();
}

TEST_P(FitOfEveryMapping, IsMinimalAgainstBruteForce) {
    RandomRanges random(5);
    int severalCascades = 0;
    int withCuts = 0;
    for (int i = 0; i < 60; ++i) {
        const SplitContext view = viewOf(GetParam(), kDepthFormats[static_cast<std::size_t>(i) % 3]);
        std::vector<Interval> intervals = random.objects(1 + i % 8, 0.2, i % 2 ? 1e2 : 1e5);
        const auto occupied =
            mergeIntervals(intervals, view.nearView, view.farView, endRounding(view.model.mapping));
        // Between what one cascade meets and what takes several.
        const Cascade all{occupied.front().nearView, occupied.back().farView};
        StepTarget target{.unitsView = i % 4 ? 0.0 : 1.0, .shareView = i % 4 ? 1.0 : 0.0};
        target = target.scaled(worstStepShare(view.model, target, all) * random.logUniform(0.02, 1.1));
        const StepTarget looser = target.scaled(1.5);
        const auto plan = planCascades(view.model, target, occupied, kMaxCascades);
        const BruteForce exact = bruteForce(view.model, target, occupied);
        const BruteForce below = bruteForce(view.model, looser, occupied);
        if (exact.cascades > kMaxCascades) {
            continue; // the grid is too coarse to say anything
        }
        ASSERT_TRUE(plan.has_value());
        EXPECT_LE(plan->size(), exact.cascades);
        EXPECT_GE(plan->size(), below.cascades) << "the grid's looser answer bounds from below";
        std::size_t cuts = 0;
        for (std::size_t k = 1; k < plan->size(); ++k) {
            cuts += (*plan)[k].nearView == (*plan)[k - 1].farView ? 1 : 0;
        }
        if (plan->size() == exact.cascades) {
            EXPECT_LE(cuts, exact.cuts);
        }
        severalCascades += plan->size() > 1 ? 1 : 0;
        withCuts += cuts > 0 ? 1 : 0;
        for (const Cascade& cascade : *plan) {
            EXPECT_LE(worstStepShare(view.model, target, cascade), 1.0);
        }
        EXPECT_TRUE(canMeet(view.model, target, occupied, plan->size()));
        EXPECT_FALSE(plan->size() > 1 && canMeet(view.model, target, occupied, plan->size() - 1));
    }
    EXPECT_GT(severalCascades, 10);
    EXPECT_GT(withCuts, 3);
}

TEST_P(FitOfEveryMapping, CoversWhatIsOccupiedAndMeetsTheTarget) {
    RandomRanges random(6);
    for (int i = 0; i < 200; ++i) {
        const SplitContext view = viewOf(GetParam(), kDepthFormats[static_cast<std::size_t>(i) % 3]);
        const auto intervals = random.objects(i, 0.05, 2e6);
        const SplitFitted split{.target = 0.05, .most = kMaxCascades};
        const Cascades cascades = fit(split, view, intervals);
        expectCovers(cascades, view, intervals);
        if (view.model.format != DepthFormat::d16) {
            EXPECT_LT(cascades.size(), kMaxCascades);
            EXPECT_LE(worstShare(cascades, view, split.target), 1.0001);
        }
    }
}

TEST_P(FitOfEveryMapping, ACapRelaxesTheTargetNoMoreThanItMust) {
    RandomRanges random(7);
    const SplitContext view = viewOf(GetParam());
    const auto intervals = random.objects(300, 0.1, 1e6);
    double previous = std::numeric_limits<double>::infinity();
    for (unsigned most = 1; most <= 6; ++most) {
        const Cascades cascades = fit({.target = 1e-5, .most = most}, view, intervals);
        expectCovers(cascades, view, intervals);
        EXPECT_LE(cascades.size(), most);
        const double worst = worstShare(cascades, view, 1e-5);
        EXPECT_LE(worst, previous * 1.001);
        previous = worst;
    }
}

TEST_P(FitOfEveryMapping, MinimaxHasTheSmallestWorstStepOfItsCount) {
    const StepModel model{GetParam(), DepthFormat::d24};
    const StepTarget unit{.unitsView = 1.0};
    const auto worstOf = [&](const Cascades& cascades) {
        double worst = 0.0;
        for (const Cascade& c : cascades) {
            worst = std::max(worst, worstStepShare(model, unit, c));
        }
        return worst;
    };
    RandomRanges random(8);
    for (unsigned count = 1; count <= 5; ++count) {
        const Cascades cascades =
            makeCascades(SplitMinimax{count}, {.nearView = 0.1, .farView = 1e4, .model = model});
        ASSERT_LE(cascades.size(), count);
        EXPECT_EQ(cascades.front().nearView, 0.1);
        EXPECT_EQ(cascades.back().farView, 1e4);
        for (int i = 0; i < 2000; ++i) {
            SplitAt other{{1e9}}; // beyond the range, so left out
            for (unsigned k = 1; k < count; ++k) {
                other.boundariesView.push_back(i % 2 ? random.uniform(0.1, 1e4)
                                                     : cascades[k - 1].farView * random.uniform(0.9, 1.1));
            }
            std::sort(other.boundariesView.begin(), other.boundariesView.end());
            EXPECT_LE(worstOf(cascades),
                      worstOf(makeCascades(other, {.nearView = 0.1, .farView = 1e4})) * 1.002);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, FitOfEveryMapping, testing::ValuesIn(kMappings), [](const auto& row) {
    std::string name(nameOf(row.param));
    std::erase(name, '-');
    return name;
});

TEST(FittedSplit, EmptySpaceCostsNothing) {
    const Cascades cascades =
        fit({}, viewOf(Mapping::anchored), {{0.9, 1.1}, {999.0, 1001.0}, {9.9e5, 9.91e5}});
    ASSERT_EQ(cascades.size(), 3u);
    EXPECT_NEAR(cascades[1].nearView, 999.0, 0.05);
    EXPECT_NEAR(cascades[1].farView, 1001.0, 0.05);
}

TEST(FittedSplit, AMillionUnitsAwayAFieldIsResolvedToMicrometres) {
    SplitContext view = viewOf(Mapping::anchored);
    view.footprintSlope = 2.0 * std::tan(std::numbers::pi / 180000.0) / 720.0;
    view.farView = 2e6;
    const std::vector<Interval> intervals{{0.109, 0.111}, {999'982.0, 1'000'018.0}};
    for (const DepthFormat format : {DepthFormat::d32f, DepthFormat::d24}) {
        view.model.format = format;
        const Cascades cascades = fit({}, view, intervals);
        ASSERT_EQ(cascades.size(), 2u);
        EXPECT_LT(stepBoundView(view.model, cascades[1], 1'000'018.0), 3e-6);
    }
}

TEST(FittedSplit, DoesNotCutWhereAGapDoes) {
    // One cascade is too few and two suffice, whether cut in the gap at 20 or within the larger interval.
    SplitContext view = viewOf(Mapping::standard);
    const std::vector<Interval> intervals{{1.0, 19.0}, {21.0, 40.0}};
    const SplitFitted split{.target = stepBoundView(view.model, {1.0, 30.0}, 30.0),
                            .unit = SplitFitted::Unit::scene};
    const Cascades cascades = fit(split, view, intervals);
    ASSERT_EQ(cascades.size(), 2u);
    EXPECT_LT(cascades[0].farView, 20.01);
    EXPECT_GT(cascades[1].nearView, 19.99);
}

TEST(FittedSplit, StaysPutUnderUlpsAndSmallSteps) {
    RandomRanges random(9);
    const SplitContext view = viewOf(Mapping::anchored);
    const auto intervals = random.objects(400, 0.2, 1e5);
    const Cascades first = fit({}, view, intervals);
    ASSERT_GT(first.size(), 2u);
    Cascades previous = first;
    for (int frame = 0; frame < 50; ++frame) {
        std::vector<Interval> moved = intervals;
        for (Interval& interval : moved) {
            interval.nearView *= 1.0 + random.uniform(-1e-12, 1e-12);
            interval.farView *= 1.0 + random.uniform(-1e-12, 1e-12);
        }
        const Cascades next = fit({}, view, moved, previous);
        EXPECT_EQ(next, first);
        previous = next;
    }
}

TEST(FittedSplit, FollowsAMovingCameraWithinItsSlack) {
    RandomRanges random(10);
    const SplitContext view = viewOf(Mapping::anchored);
    const auto intervals = random.objects(200, 10.0, 1e5);
    Cascades previous;
    int changes = 0;
    for (int frame = 0; frame < 300; ++frame) {
        std::vector<Interval> moved = intervals;
        for (Interval& interval : moved) {
            interval.nearView -= 0.02 * frame;
            interval.farView -= 0.02 * frame;
        }
        const Cascades next = fit({}, view, moved, previous);
        expectCovers(next, view, moved);
        EXPECT_LE(worstShare(next, view, SplitFitted{}.target), 1.0 + kFitSlack + 1e-9);
        changes += next.size() != previous.size() ? 1 : 0;
        previous = next;
    }
    EXPECT_LE(changes, 6);
}

/// The figures of SplitFitted::target, with a 60 degree lens.
TEST(FittedSplit, ACascadeSpansTheRatioThatTheHeaderNames) {
    struct Picture {
        double rows;
        double ratio;
        std::size_t cascades;
    };
    std::vector<Interval> small;
    for (double at = 0.1; at < 1e5; at *= 1.001) {
        small.push_back({at, std::min(1.00101 * at, 1e5)});
    }
    for (const Picture& picture : {Picture{180.0, 109.0, 3}, Picture{720.0, 28.0, 5},
                                   Picture{1080.0, 19.0, 5}, Picture{2160.0, 10.0, 7}}) {
        SplitContext view = viewOf(Mapping::anchored);
        view.farView = 1e5;
        view.footprintSlope = 2.0 * std::tan(std::numbers::pi / 6.0) / picture.rows;
        const Cascades cascades = fit({}, view, small);
        EXPECT_EQ(cascades.size(), picture.cascades) << picture.rows;
        EXPECT_NEAR(cascades[0].farView / cascades[0].nearView, picture.ratio, 0.6) << picture.rows;
    }
}

TEST(FittedSplit, TheCountDoesNotFlickerAtItsThreshold) {
    const SplitContext view = viewOf(Mapping::anchored);
    const std::vector<Interval> whole{{1.0, 100.0}};
    const double atThreshold = stepBoundView(view.model, {1.0, 100.0}, 100.0);
    for (const double side : {1.0 - 1e-9, 1.0 + 1e-9}) {
        const SplitFitted split{.target = atThreshold * side, .unit = SplitFitted::Unit::scene};
        EXPECT_EQ(fit(split, view, whole).size(), side < 1.0 ? 2u : 1u);
        EXPECT_EQ(fit(split, view, whole, {{0.99, 100.5}}).size(), 1u);
        EXPECT_EQ(fit(split, view, whole, {{0.99, 50.0}, {50.0, 100.5}}).size(), 2u);
    }
}

TEST(FittedSplit, DegenerateInputs) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const Mapping mapping : kMappings) {
        for (const DepthFormat format : kDepthFormats) {
            const SplitContext view = viewOf(mapping, format);
            const std::vector<std::vector<Interval>> cases{
                {},
                {{5.0, 5.0}},
                {{0.1, 0.1}},
                {{1e6, 1e6}},
                {{-3.0, 4.0}},
                {{-1e9, 1e9}},
                {{-kInfinity, kInfinity}},
                {{-2.0, -1.0}, {2e6, 3e6}},
                {{kNan, 5.0}, {5.0, kNan}, {kNan, kNan}},
                {{kNan, 5.0}, {7.0, 8.0}},
                {{8.0, 7.0}},
                {{5.0, 5.0}, {std::nextafter(5.0, 6.0), 5.1}, {5.1, 5.2}, {5.2 * (1.0 + 1e-13), 5.3}},
                std::vector<Interval>(5000, {10.0, 20.0})};
            for (const auto& intervals : cases) {
                for (const unsigned most : {1u, 3u, 64u}) {
                    for (const double target : {1e-300, 1e-6, 1e300}) {
                        const SplitFitted split{.target = target, .most = most};
                        const Cascades cascades = fit(split, view, intervals);
                        std::vector<Interval> sound;
                        std::copy_if(intervals.begin(), intervals.end(), std::back_inserter(sound),
                                     [](const Interval& i) { return i.nearView <= i.farView; });
                        expectCovers(cascades, view, sound);
                        EXPECT_LE(cascades.size(), most);
                        expectCovers(fit(split, view, intervals, cascades), view, sound);
                    }
                }
            }
        }
    }
}

/// Points and what is as thin as float64 resolves, as close together as that, at the ends of the range and between them.
TEST(FittedSplit, EveryCascadeHasAThickness) {
    RandomRanges random(12);
    for (int i = 0; i < 5'000; ++i) {
        SplitContext view = viewOf(kMappings[i % kMappings.size()], kDepthFormats[i % kDepthFormats.size()]);
        view.nearView = random.logUniform(1e-3, 1e3);
        view.farView = view.nearView * (1.0 + random.logUniform(1e-15, 1e6));
        std::vector<Interval> intervals{{view.farView, view.farView}};
        double at = i % 3 == 0 ? view.nearView
                               : view.nearView + random.uniform(0.0, 1.0) * (view.farView - view.nearView);
        for (int object = i % 5; object >= 0; --object) {
            const double end = object % 2 == 0 ? at : at * (1.0 + random.logUniform(1e-16, 1e-5));
            intervals.push_back({at, end});
            at = end * (1.0 + random.logUniform(1e-16, 1e-5));
        }
        const SplitFitted split{.target = random.logUniform(1e-12, 1.0),
                                .unit = i % 2 == 0 ? SplitFitted::Unit::pixels : SplitFitted::Unit::scene,
                                .most = 1u + static_cast<unsigned>(i % 8)};
        const Cascades cascades = fit(split, view, intervals);
        expectCovers(cascades, view, intervals);
        expectCovers(fit(split, view, intervals, cascades), view, intervals);
        ASSERT_FALSE(HasFailure()) << i;
    }
}

/// The thinnest object decides how fine cascades are, so it must be one that is there.
TEST(SplitFitted, WhatIsOutOfTheCamerasRangeChangesNothing) {
    SplitContext view = viewOf(Mapping::anchored);
    view.farView = 1e5;
    const Cascades alone = fit({}, view, {{0.1, 1e5}});
    for (const Interval& away : {Interval{-2.0, -1.999}, Interval{0.01, 0.0101}, Interval{2e5, 2e5 + 1e-3}}) {
        const Cascades cascades = fit({}, view, {{0.1, 1e5}, away});
        EXPECT_EQ(cascades.size(), alone.size()) << away.nearView;
    }
    EXPECT_GT(fit({}, view, {{0.1, 1e5}, {2.0, 2.001}}).size(), alone.size());
}

/// As mergeIntervals() says it, one step after the other.
std::vector<Interval> mergedPlainly(std::vector<Interval> intervals, double nearView, double farView,
                                    double rounding) {
    std::erase_if(intervals, [&](const Interval& i) {
        return !(i.nearView <= farView && i.farView >= nearView && i.nearView <= i.farView);
    });
    for (Interval& interval : intervals) {
        interval = {std::max(interval.nearView, nearView), std::min(interval.farView, farView)};
    }
    std::ranges::sort(intervals, {}, &Interval::nearView);
    std::vector<Interval> merged;
    for (const Interval& interval : intervals) {
        if (!merged.empty() && interval.nearView <= merged.back().farView * (1.0 + 2.0 * rounding)) {
            merged.back().farView = std::max(merged.back().farView, interval.farView);
        } else {
            merged.push_back(interval);
        }
    }
    return merged;
}

/// Few and many, thin and thick, spread over one decade and over eleven.
TEST(MergeIntervals, AnyAreMergedAsByAPlainSort) {
    RandomRanges random(11);
    std::size_t most = 0;
    for (const int count : {1, 2, 100, 1'600, 20'000}) {
        for (const double last : {0.1, 1e9}) {
            for (const double thickness : {0.0, 1e-7, 1e-4, 1e-2, 1.0}) {
                auto intervals = random.objects(count, 0.01, last);
                for (Interval& interval : intervals) {
                    interval.farView = interval.nearView + thickness * (interval.farView - interval.nearView);
                }
                intervals.push_back({kNan, 1.0});
                for (const double rounding : {0.0, 1e-6}) {
                    const auto expected = mergedPlainly(intervals, 0.02, 1e8, rounding);
                    most = std::max(most, expected.size());
                    auto given = intervals;
                    const auto merged = mergeIntervals(given, 0.02, 1e8, rounding);
                    ASSERT_EQ(merged.size(), expected.size()) << count << " " << last << " " << thickness;
                    for (std::size_t i = 0; i < merged.size(); ++i) {
                        ASSERT_EQ(merged[i].nearView, expected[i].nearView);
                        ASSERT_EQ(merged[i].farView, expected[i].farView);
                    }
                }
            }
        }
    }
    EXPECT_GT(most, 10'000u);
}

} // namespace
