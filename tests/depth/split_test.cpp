#include <cdr/base/error.h>
#include <cdr/depth/make_cascades.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace {

using namespace cdr::depth;
using cdr::base::InputError;

void expectCover(const Cascades& cascades, double nearView, double farView) {
    ASSERT_FALSE(cascades.empty());
    ASSERT_LE(cascades.size(), kMaxCascades);
    EXPECT_EQ(cascades.front().nearView, nearView);
    EXPECT_EQ(cascades.back().farView, farView);
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        EXPECT_LT(cascades[i].nearView, cascades[i].farView);
        if (i > 0) {
            EXPECT_EQ(cascades[i].nearView, cascades[i - 1].farView);
        }
    }
}

Cascades cut(const Split& split, double nearView, double farView) {
    return makeCascades(split, {.nearView = nearView, .farView = farView});
}

TEST(Split, CoversAnyRangeWithoutGap) {
    std::mt19937_64 engine(7);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<>(low, high)(engine);
    };
    for (int i = 0; i < 2000; ++i) {
        const double nearView = std::pow(10.0, uniform(-6.0, 6.0));
        const double farView = nearView * (1.0 + std::pow(10.0, uniform(-9.0, 12.0)));
        for (const Split& split :
             {Split(SplitNone{}), Split(SplitRatio{uniform(2.0, 5000.0)}),
              Split(SplitCount{1 + static_cast<unsigned>(i) % 64}),
              Split(SplitAt{{nearView * 0.5, std::sqrt(nearView * farView), farView * 2.0}})}) {
            expectCover(cut(split, nearView, farView), nearView, farView);
        }
    }
}

TEST(Split, RatioFollowsListing52) {
    const Cascades cascades = cut(SplitRatio{1000.0}, 0.1, 12000.0);
    ASSERT_EQ(cascades.size(), 2u);
    EXPECT_DOUBLE_EQ(cascades[0].farView, 100.0);
    // The 2AFC scene's field straddles this boundary, which is why cdr gains so little there.
    EXPECT_DOUBLE_EQ(cut(SplitRatio{1000.0}, 0.001, 2e6)[2].farView, 1e6);
}

/// The product of ratios may round to a little less than far, and the quotient of logarithms to a little more than a whole number.
TEST(Split, RatioMakesNoCascadeOfRoundingsWhereFarIsAWholePower) {
    for (const double ratio : {1.3, 1.4, 2.0, 3.0, 7.0, 10.0, 1000.0}) {
        for (const double nearView : {0.001, 0.1, 0.3, 1.0, 0.7}) {
            for (std::size_t count = 1; count <= kMaxCascades && std::pow(ratio, count) < 1e30; ++count) {
                const Cascades cascades =
                    cut(SplitRatio{ratio}, nearView, nearView * std::pow(ratio, static_cast<double>(count)));
                ASSERT_EQ(cascades.size(), count) << ratio << ' ' << nearView;
                EXPECT_NEAR(cascades.back().farView / cascades.back().nearView, ratio, 1e-9 * ratio);
            }
        }
    }
    EXPECT_EQ(cut(SplitRatio{3.0}, 0.3, 2.7).size(), 2u);
    EXPECT_EQ(cut(SplitRatio{3.0}, 0.3, 2.7 * (1.0 + 1e-6)).size(), 3u);
}

TEST(Split, CountHasEqualRatios) {
    const Cascades cascades = cut(SplitCount{5}, 0.1, 1e5);
    ASSERT_EQ(cascades.size(), 5u);
    for (const Cascade& cascade : cascades) {
        EXPECT_NEAR(cascade.farView / cascade.nearView, std::pow(1e6, 0.2), 1e-9);
    }
}

TEST(Split, TextReadsBack) {
    for (const char* text :
         {"none", "ratio:1000", "ratio:2.5", "count:7", "at:1,20,300.5", "minimax:3", "fitted",
          "fitted:0.5px", "fitted:1e-05", "fitted:0.25,max=3", "fitted:0.001px,max=64"}) {
        EXPECT_EQ(nameOf(parseSplit(text)), text);
        EXPECT_EQ(parseSplit(nameOf(parseSplit(text))), parseSplit(text));
    }
}

TEST(Split, RefusesNonsense) {
    for (const char* text :
         {"",           "ratio",          "ratio:",          "ratio:1",        "ratio:-3",    "ratio:nan",
          "count:0",    "count:65",       "count:2.5",       "count:-1",       "at:",         "at:1,,2",
          "at:2,1",     "at:1,1",         "at:-1,2",         "at:0",           "fitte",       "none:1",
          "minimax:0",  "minimax",        "fitted:",         "fitted:px",      "fitted:0px",  "fitted:-1",
          "fitted:nan", "fitted:1,max=0", "fitted:1,max=65", "fitted:1,min=2", "fitted,max=3"}) {
        EXPECT_THROW(parseSplit(text), InputError) << text;
    }
}

TEST(Split, ACountMadeByHandIsRefusedBeforeItTakesMemory) {
    const SplitContext context{.nearView = 1.0, .farView = 1e6};
    EXPECT_EQ(makeCascades(SplitCount{kMaxCascades}, context).size(), kMaxCascades);
    for (const unsigned count : {unsigned{kMaxCascades} + 1, std::numeric_limits<unsigned>::max()}) {
        EXPECT_THROW(makeCascades(SplitCount{count}, context), InputError) << count;
    }
}

std::string problemOf(const Split& split) {
    const auto problem = splitProblem(split);
    return problem ? problem->message : "none";
}

/// What makeCascades() says of it.
std::string refusalOf(const Split& split) {
    const auto cascades =
        tryMakeCascades(split, {.nearView = 1.0, .farView = 100.0, .footprintSlope = 0.001});
    return cascades ? "none" : cascades.refusal().message;
}

TEST(Split, ASplitMadeByHandIsRefusedAsItsTextIs) {
    constexpr unsigned kMany = unsigned{kMaxCascades} + 1;
    for (const Split& split :
         {Split(SplitRatio{1.0}), Split(SplitRatio{-3.0}), Split(SplitCount{0}), Split(SplitCount{kMany}),
          Split(SplitMinimax{0}), Split(SplitMinimax{kMany}), Split(SplitAt{{2.0, 1.0}}),
          Split(SplitAt{{1.0, 1.0}}), Split(SplitAt{{0.0}}), Split(SplitFitted{.target = 0.0}),
          Split(SplitFitted{.target = -1.0, .unit = SplitFitted::Unit::scene}), Split(SplitFitted{.most = 0}),
          Split(SplitFitted{.most = kMany})}) {
        const auto parsed = tryParseSplit(nameOf(split));
        ASSERT_FALSE(parsed) << nameOf(split);
        EXPECT_EQ(problemOf(split), parsed.refusal().message);
        EXPECT_EQ(refusalOf(split), parsed.refusal().message);
    }
    EXPECT_EQ(problemOf(SplitAt{{1e9}}), "none");
    EXPECT_EQ(problemOf(SplitCount{kMaxCascades}), "none");
    EXPECT_EQ(problemOf(SplitFitted{.most = kMaxCascades}), "none");
}

TEST(Split, NoBoundariesAreRefusedSinceNoTextHasNone) {
    EXPECT_EQ(problemOf(SplitAt{}), "a split at boundaries must have one at least");
    EXPECT_EQ(refusalOf(SplitAt{}), problemOf(SplitAt{}));
}

TEST(Split, NumbersThatAreNoneAreRefused) {
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(refusalOf(SplitRatio{value}).find("split ratio must be a finite number"), 0u) << value;
        EXPECT_EQ(refusalOf(SplitFitted{.target = value}).find("target of a fitted split must be a finite"),
                  0u)
            << value;
    }
    EXPECT_EQ(refusalOf(SplitAt{{2.0, std::numeric_limits<double>::quiet_NaN()}}),
              "split boundaries must be above 0 and ascend");
}

TEST(Split, RefusesToFitPixelsOfUnknownSize) {
    EXPECT_THROW(cut(SplitFitted{}, 1.0, 2.0), InputError);
    EXPECT_EQ(cut(SplitFitted{.unit = SplitFitted::Unit::scene}, 1.0, 2.0), (Cascades{{1.0, 2.0}}));
}

TEST(Split, RefusesUnusableRanges) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const auto& [n, f] : {std::pair{0.0, 1.0},
                               {-1.0, 1.0},
                               {1.0, 1.0},
                               {2.0, 1.0},
                               {kNan, 1.0},
                               {1.0, kNan},
                               {1.0, kInfinity},
                               {1e-300, 1.0},
                               {1.0, 1e160},
                               {1e-31, 1.0},
                               {1.0, 1e31},
                               {1e-20, 1e20},
                               {kInfinity, kInfinity}}) {
        EXPECT_THROW(cut(SplitNone{}, n, f), InputError) << n << " " << f;
    }
    EXPECT_THROW(cut(SplitRatio{1.0000001}, 0.001, 1e8), InputError);
    EXPECT_THROW(cut(SplitRatio{0.5}, 0.001, 1e8), InputError);
}

} // namespace
