#include "../support/all_cases.h"

#include <cdr/base/error.h>
#include <cdr/depth/advice.h>
#include <cdr/depth/make_cascades.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace {

using namespace cdr::depth;

/// Numbers from all of float64, the ends of its range, and usual ones.
class AnyNumbers {
  public:
    explicit AnyNumbers(std::uint64_t seed) : m_engine(seed) {}

    std::size_t below(std::size_t count) { return static_cast<std::size_t>(m_engine() % count); }
    double logUniform(double low, double high) {
        return std::exp(std::uniform_real_distribution<>(std::log(low), std::log(high))(m_engine));
    }
    /// Any bit pattern, with negative, subnormal and infinite numbers and NaN.
    double anyBits() { return std::bit_cast<double>(m_engine()); }
    double positive() {
        using Limits = std::numeric_limits<double>;
        switch (below(8)) {
        case 0:
            return std::abs(anyBits());
        case 1:
            return Limits::denorm_min();
        case 2:
            return Limits::max();
        case 3:
            return kMinView;
        case 4:
            return kMaxView;
        default:
            return logUniform(kMinView, kMaxView);
        }
    }

  private:
    std::mt19937_64 m_engine;
};

/// Whether a call ends in a value or in InputError; anything else is a defect.
template <typename Call>
auto valueOf(const Call& call) -> std::optional<decltype(call())> {
    try {
        return call();
    } catch (const cdr::base::InputError&) {
        return std::nullopt;
    }
}

void expectSound(const Cascades& cascades, const SplitContext& context) {
    ASSERT_FALSE(cascades.empty());
    ASSERT_LE(cascades.size(), kMaxCascades);
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        ASSERT_GE(cascades[i].nearView, context.nearView);
        ASSERT_LT(cascades[i].nearView, cascades[i].farView);
        ASSERT_LE(cascades[i].farView, context.farView);
        ASSERT_TRUE(i == 0 || cascades[i].nearView >= cascades[i - 1].farView);
    }
}

/// 22,000 in both tests, with CDR_ALL_CASES 100,000.
int casesOf(int sample, int all) {
    return cdr::test::takesAllCases() ? all : sample;
}

/// Calls `test` that many times. Each may take two seconds of the CPU, a thousand times what it needs.
template <typename Test>
void forEachCase(int cases, const Test& test) {
    for (int i = 0; i < cases && !testing::Test::HasFatalFailure(); ++i) {
        const std::clock_t start = std::clock();
        test(i);
        ASSERT_LT(std::clock() - start, 2 * CLOCKS_PER_SEC) << "case " << i;
    }
}

TEST(WholeRange, EverySplitEndsInSoundCascadesOrIsRefused) {
    AnyNumbers random(1);
    int cut = 0;
    forEachCase(casesOf(20'000, 90'000), [&](int) {
        SplitContext context{.nearView = random.positive(),
                             .farView = random.positive(),
                             .model = {kMappings[random.below(kMappings.size())],
                                       kDepthFormats[random.below(kDepthFormats.size())]},
                             .footprintSlope = random.positive()};
        if (context.nearView > context.farView) {
            std::swap(context.nearView, context.farView);
        }
        if (random.below(4) != 0) {
            context.farView = std::min(context.farView, kMaxFarOverNear * context.nearView);
        }
        std::vector<Interval> visible(random.below(4));
        for (Interval& interval : visible) {
            interval = random.below(4) == 0 ? Interval{random.anyBits(), random.anyBits()}
                                            : Interval{random.positive(), random.positive()};
        }
        context.visible = visible;
        const auto most = static_cast<unsigned>(1 + random.below(8));
        const std::vector<Split> splits{
            SplitRatio{random.positive()}, SplitCount{most}, SplitMinimax{most},
            SplitFitted{.target = random.positive(), .unit = SplitFitted::Unit::pixels, .most = most},
            SplitFitted{.target = random.positive(), .unit = SplitFitted::Unit::scene, .most = most}};
        const Split& split = splits[random.below(splits.size())];
        SCOPED_TRACE(testing::Message()
                     << nameOf(split) << " near " << context.nearView << " far " << context.farView << " "
                     << nameOf(context.model.mapping) << " " << nameOf(context.model.format) << " slope "
                     << context.footprintSlope);
        const auto first = valueOf([&] { return makeCascades(split, context); });
        if (first) {
            ++cut;
            expectSound(*first, context);
            context.previous = *first;
            const auto second = valueOf([&] { return makeCascades(split, context); });
            ASSERT_TRUE(second.has_value());
            expectSound(*second, context);
        }
    });
    EXPECT_GT(cut, 5'000);
}

TEST(WholeRange, AdviceEndsInAnAnswerOrIsRefused) {
    AnyNumbers random(2);
    int answered = 0;
    forEachCase(casesOf(2'000, 10'000), [&](int) {
        AdviceQuestion question{.scene = {.nearView = random.positive(),
                                          .farView = random.positive(),
                                          .footprintSlope = random.positive(),
                                          .atView = random.positive(),
                                          .spanView = random.positive()},
                                .separationView = random.positive()};
        if (random.below(2) == 0) {
            // A range that is usable, so that the rest is reached.
            question.scene.nearView = random.logUniform(kMinView, 1.0);
            question.scene.farView =
                std::min(random.logUniform(2.0, kMaxView), kMaxFarOverNear * question.scene.nearView);
            question.scene.atView = random.logUniform(question.scene.nearView, question.scene.farView);
        }
        SCOPED_TRACE(testing::Message()
                     << "near " << question.scene.nearView << " far " << question.scene.farView << " slope "
                     << question.scene.footprintSlope << " at " << question.scene.atView << " span "
                     << question.scene.spanView << " separation " << question.separationView);
        const auto advice = valueOf([&] { return advise(question); });
        if (advice) {
            ++answered;
            EXPECT_FALSE(explain(question, *advice).empty());
            for (const AdviceRow& row : advice->rows) {
                ASSERT_FALSE(std::isnan(row.resolvedView())) << nameOf(row.technique);
            }
        }
    });
    EXPECT_GT(answered, 500);
}

} // namespace
