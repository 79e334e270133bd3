#include <cdr/base/error.h>
#include <cdr/depth/mapping.h>
#include <cdr/depth/technique.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace cdr::depth;

/// Random ranges from microscopic to astronomical.
class Ranges {
  public:
    DepthRange next(Mapping mapping) {
        const double nearView = std::pow(10.0, uniform(-4.0, 4.0));
        const double farView = nearView * (1.0 + std::pow(10.0, uniform(-3.0, 8.0)));
        return {.mapping = mapping, .nearView = nearView, .farView = farView};
    }
    double within(const DepthRange& range) {
        return range.nearView * std::pow(*range.farView / range.nearView, uniform(0.0, 1.0));
    }
    double uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(m_engine); }

  private:
    std::mt19937_64 m_engine{1};
};

class EveryMapping : public testing::TestWithParam<Mapping> {};

TEST_P(EveryMapping, MapsNearAndFarToTheEndsOfTheRange) {
    Ranges ranges;
    for (int i = 0; i < 1000; ++i) {
        const DepthRange range = ranges.next(GetParam());
        const double atNear = isReversed(range.mapping) ? 1.0 : 0.0;
        EXPECT_NEAR(zNdcAt(range, range.nearView), atNear, 1e-9);
        EXPECT_NEAR(zNdcAt(range, *range.farView), 1.0 - atNear, 1e-9);
    }
}

TEST_P(EveryMapping, IsStrictlyMonotone) {
    Ranges ranges;
    for (int i = 0; i < 1000; ++i) {
        const DepthRange range = ranges.next(GetParam());
        const double a = ranges.within(range);
        const double b = a + (*range.farView - a) * ranges.uniform(0.01, 1.0);
        const double sign = isReversed(range.mapping) ? -1.0 : 1.0;
        // Far away under a huge ratio the exact depths differ by less than float64 resolves.
        if (*range.farView / range.nearView < 1e6) {
            EXPECT_GT(sign * (zNdcAt(range, b) - zNdcAt(range, a)), 0.0);
        } else {
            EXPECT_GE(sign * (zNdcAt(range, b) - zNdcAt(range, a)), 0.0);
        }
    }
}

TEST_P(EveryMapping, RoundTrips) {
    Ranges ranges;
    for (int i = 0; i < 1000; ++i) {
        DepthRange range = ranges.next(GetParam());
        // Depth near 1 holds far distances to (w/n) ulp, so a moderate ratio keeps the tolerance meaningful.
        if (range.mapping != Mapping::reversed) {
            range.farView = std::min(*range.farView, range.nearView * 1e4);
        }
        const double w = ranges.within(range);
        EXPECT_NEAR(distanceViewAt(range, zNdcAt(range, w)) / w, 1.0, 1e-10);
    }
}

INSTANTIATE_TEST_SUITE_P(All, EveryMapping, testing::ValuesIn(kMappings), [](const auto& row) {
    std::string name(nameOf(row.param));
    std::erase(name, '-');
    return name;
});

TEST(Mapping, InfiniteReversedIsNearOverDistance) {
    const DepthRange range{.mapping = Mapping::reversed, .nearView = 0.5, .farView = std::nullopt};
    EXPECT_DOUBLE_EQ(zNdcAt(range, 0.5), 1.0);
    EXPECT_DOUBLE_EQ(zNdcAt(range, 1e9), 0.5e-9);
    EXPECT_DOUBLE_EQ(distanceViewAt(range, 0.5e-9), 1e9);
}

TEST(Mapping, AnchoredEqualsStandard) {
    const DepthRange anchored{.mapping = Mapping::anchored, .nearView = 1000.0, .farView = 1010.0};
    DepthRange standard = anchored;
    standard.mapping = Mapping::standard;
    for (double w = 1000.0; w <= 1010.0; w += 0.37) {
        EXPECT_NEAR(zNdcAt(anchored, w), zNdcAt(standard, w), 1e-12);
    }
}

TEST(Mapping, MatchesTheThesisEquation) {
    // Equation 1.1: a + b/z with a = f/(f-n), b = fn/(n-f).
    const DepthRange range{.mapping = Mapping::standard, .nearView = 0.1, .farView = 100.0};
    EXPECT_DOUBLE_EQ(zNdcAt(range, 7.0), 100.0 / 99.9 - 10.0 / 99.9 / 7.0);
    const DepthRange log{.mapping = Mapping::log, .nearView = 0.1, .farView = 100.0};
    EXPECT_DOUBLE_EQ(zNdcAt(log, 7.0), std::log(70.0) / std::log(1000.0));
}

TEST(Mapping, OnlyTheLastReversedCascadeIsOpen) {
    const Cascades cascades{{1.0, 10.0}, {10.0, 100.0}};
    EXPECT_TRUE(depthRange(Mapping::reversed, cascades, 0).farView.has_value());
    EXPECT_FALSE(depthRange(Mapping::reversed, cascades, 1).farView.has_value());
    EXPECT_TRUE(depthRange(Mapping::standard, cascades, 1).farView.has_value());
    EXPECT_TRUE(depthRange(Mapping::reversed, cascades, 1, FarEnd::closed).farView.has_value());
}

TEST(ClipRange, EndsWhereTheNextCascadeDoes) {
    const Cascades cascades{{1.0, 1000.0}, {1000.0, 1000.0001}};
    for (const Mapping mapping : kMappings) {
        EXPECT_EQ(clipRange(mapping, cascades, 0).farView, 1000.0001) << nameOf(mapping);
    }
}

TEST(ClipRange, OverlapsIntoTheNextCascadeOnly) {
    const Cascades cascades{{1.0, 1000.0}, {1000.0, 1e6}};
    for (const Mapping mapping : kMappings) {
        EXPECT_EQ(clipRange(mapping, cascades, 0).nearView, 1.0);
        EXPECT_GT(clipRange(mapping, cascades, 0).farView, 1000.0);
        // Reversed, anchored depth shares what the next cascade rounds, whose thickness is a million.
        EXPECT_LT(clipRange(mapping, cascades, 0).farView,
                  mapping == Mapping::anchoredReversed ? 1001.0 : 1000.2);
        EXPECT_EQ(clipRange(mapping, cascades, 1), cascades[1]);
    }
}

/// Its anchor is its far plane, so it rounds by its thickness where they meet.
TEST(ClipRange, AnchoredReversedSharesAMillionthOfTheNextCascadeWhereThatIsThick) {
    const Cascades cascades{{0.1, 3165.0}, {3165.0, 1e8}};
    EXPECT_NEAR(clipRange(Mapping::anchoredReversed, cascades, 0).farView, 3265.0, 0.01);
    EXPECT_LT(clipRange(Mapping::anchored, cascades, 0).farView, 3166.0);
}

/// What is shared follows the distance, as what float32 rounds does. But depth gets a hundredth coarser at most.
TEST(ClipRange, AnchoredCascadesShareAMillionthOfTheDistanceWhereTheyAreThin) {
    for (const Mapping mapping : {Mapping::anchored, Mapping::anchoredReversed}) {
        for (const double thickness : {1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1}) {
            const double meetView = 1e6;
            const double thicknessView = thickness * meetView;
            const Cascades cascades{{meetView - thicknessView, meetView},
                                    {meetView, meetView + thicknessView}};
            const double sharedView = clipRange(mapping, cascades, 0).farView - meetView;
            EXPECT_LE(sharedView, 0.0101 * thicknessView) << nameOf(mapping) << " " << thickness;
            EXPECT_GE(sharedView, 0.0099 * std::min(thicknessView, 1e-4 * meetView))
                << nameOf(mapping) << " " << thickness;
        }
    }
}

TEST(ClipRange, DoesNotReachIntoAGap) {
    const Cascades cascades{{1.0, 10.0}, {20.0, 30.0}};
    for (const Mapping mapping : kMappings) {
        EXPECT_EQ(clipRange(mapping, cascades, 0), cascades[0]);
    }
}

TEST(Names, ReadBackAndSuggest) {
    for (const Mapping mapping : kMappings) {
        EXPECT_EQ(parseMapping(nameOf(mapping)), mapping);
    }
    for (const DepthFormat format : kDepthFormats) {
        EXPECT_EQ(parseDepthFormat(nameOf(format)), format);
    }
    for (const NamedTechnique& preset : presets()) {
        EXPECT_EQ(parseTechnique(preset.name), preset.technique);
        EXPECT_EQ(nameOf(preset.technique), preset.name);
        EXPECT_EQ(namedTechnique(preset.name).name, preset.name);
        EXPECT_EQ(namedTechnique(partsOf(preset.technique)).name, partsOf(preset.technique));
        for (const DepthFormat format : kDepthFormats) {
            EXPECT_EQ(nameOf(Technique{preset.technique.mapping, preset.technique.split, format}),
                      preset.name);
        }
    }
    for (const Mapping mapping : kMappings) {
        const Technique made = Technique{mapping, parseSplit("count:3"), DepthFormat::d32f};
        EXPECT_EQ(parseTechnique(nameOf(made)), made);
    }
    EXPECT_THROW(parseTechnique("anchored/fited"), cdr::base::InputError);
    EXPECT_THROW(parseTechnique("anchord/fitted"), cdr::base::InputError);
    EXPECT_THROW(parseMapping("standrad"), cdr::base::InputError);
    EXPECT_THROW(parseDepthFormat("d32"), cdr::base::InputError);
    EXPECT_THROW(parseTechnique(""), cdr::base::InputError);
}

TEST(DepthStep, IsTheGapBetweenStoredValues) {
    EXPECT_DOUBLE_EQ(depthStep(DepthFormat::d16, 0.3), 1.0 / 65535.0);
    EXPECT_DOUBLE_EQ(depthStep(DepthFormat::d24, 0.3), 1.0 / 16777215.0);
    EXPECT_DOUBLE_EQ(depthStep(DepthFormat::d32f, 1.0), 0x1p-24);
    EXPECT_DOUBLE_EQ(depthStep(DepthFormat::d32f, 0.3), 0x1p-25);
    for (const DepthFormat format : kDepthFormats) {
        const double z = quantize(format, 0.7123456789);
        EXPECT_EQ(quantize(format, z), z);
        EXPECT_NE(quantize(format, z - depthStep(format, z)), z);
    }
}

} // namespace
