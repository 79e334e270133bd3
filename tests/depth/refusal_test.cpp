#include "../support/refusal.h"

#include <cdr/base/error.h>
#include <cdr/depth/advice.h>
#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/make_cascades.h>
#include <cdr/depth/separation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace cdr::depth {

namespace {

/// A bad call, once refused and once thrown.
struct BadCall {
    const char* what;
    std::function<std::optional<std::string>()> refused; ///< the message; empty where there was a value
    std::function<void()> thrown;
};

template <typename Value>
std::optional<std::string> messageOf(const base::Result<Value>& result) {
    return result ? std::nullopt : std::optional(result.refusal().message);
}

const SplitContext kContext{.nearView = 0.1, .farView = 1e5};
const ForecastScene kFarAway{.atView = 1e9};
const ForecastScene kSnappedTooFine{.subPixelBits = 33};
const ForecastScene kOverhanging{.footprintSlope = 0.001, .subPixelBits = 8, .slope = -1.0};
const ForecastScene kUnknownPixels{.footprintSlope = std::numeric_limits<double>::quiet_NaN(),
                                   .subPixelBits = 8};

const Cascades kOneCascade{{.nearView = 1.0, .farView = 2.0}};
const Projection kLens{.fovY = 1.0, .aspect = 1.5};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

BadCall constantsCall(const char* what, std::size_t index, const Projection& lens) {
    return {what, [=] { return messageOf(tryCascadeConstants(Mapping::anchored, kOneCascade, index, lens)); },
            [=] { cascadeConstants(Mapping::anchored, kOneCascade, index, lens); }};
}

const std::vector<BadCall> kBadCalls{
    {"mapping", [] { return messageOf(tryParseMapping("lag")); }, [] { parseMapping("lag"); }},
    {"format", [] { return messageOf(tryParseDepthFormat("d17")); }, [] { parseDepthFormat("d17"); }},
    {"split", [] { return messageOf(tryParseSplit("half")); }, [] { parseSplit("half"); }},
    {"ratio", [] { return messageOf(tryParseSplit("ratio:1")); }, [] { parseSplit("ratio:1"); }},
    {"ratio's text", [] { return messageOf(tryParseSplit("ratio:x")); }, [] { parseSplit("ratio:x"); }},
    {"count", [] { return messageOf(tryParseSplit("count:0.5")); }, [] { parseSplit("count:0.5"); }},
    {"count's text", [] { return messageOf(tryParseSplit("count:")); }, [] { parseSplit("count:"); }},
    {"boundaries", [] { return messageOf(tryParseSplit("at:2,1")); }, [] { parseSplit("at:2,1"); }},
    {"boundary", [] { return messageOf(tryParseSplit("at:2,")); }, [] { parseSplit("at:2,"); }},
    {"target", [] { return messageOf(tryParseSplit("fitted:0px")); }, [] { parseSplit("fitted:0px"); }},
    {"most", [] { return messageOf(tryParseSplit("fitted:1,max=99")); },
     [] { parseSplit("fitted:1,max=99"); }},
    {"technique", [] { return messageOf(tryNamedTechnique("cdx")); }, [] { namedTechnique("cdx"); }},
    {"technique's mapping", [] { return messageOf(tryNamedTechnique("a/none")); },
     [] { namedTechnique("a/none"); }},
    {"technique's split", [] { return messageOf(tryNamedTechnique("log/a")); },
     [] { namedTechnique("log/a"); }},
    {"range", [] { return messageOf(tryMakeCascades(SplitNone{}, {})); },
     [] { makeCascades(SplitNone{}, {}); }},
    {"bounds of the range",
     [] { return messageOf(tryMakeCascades(SplitNone{}, {.nearView = 1e-50, .farView = 1})); },
     [] { makeCascades(SplitNone{}, {.nearView = 1e-50, .farView = 1}); }},
    {"too many cascades", [] { return messageOf(tryMakeCascades(SplitRatio{1.01}, kContext)); },
     [] { makeCascades(SplitRatio{1.01}, kContext); }},
    {"no footprint", [] { return messageOf(tryMakeCascades(SplitFitted{}, kContext)); },
     [] { makeCascades(SplitFitted{}, kContext); }},
    {"distance", [] { return messageOf(tryForecast({}, kFarAway)); }, [] { forecast({}, kFarAway); }},
    {"sub-pixel bits", [] { return messageOf(tryForecast({}, kSnappedTooFine)); },
     [] { forecast({}, kSnappedTooFine); }},
    {"slope", [] { return messageOf(tryForecast({}, kOverhanging)); }, [] { forecast({}, kOverhanging); }},
    {"pixels of snapping", [] { return messageOf(tryForecast({}, kUnknownPixels)); },
     [] { forecast({}, kUnknownPixels); }},
    {"separation", [] { return messageOf(tryAdvise({.scene = {}, .separationView = 0.0})); },
     [] { advise({.scene = {}, .separationView = 0.0}); }},
    {"technique by name", [] { return messageOf(tryParseTechnique("cdx")); }, [] { parseTechnique("cdx"); }},
    {"the thesis' mapping",
     [] { return messageOf(tryThesisSeparationView(Mapping::anchored, kOneCascade, 24, 1.0)); },
     [] { thesisSeparationView(Mapping::anchored, kOneCascade, 24, 1.0); }},
    constantsCall("no such cascade", 1, kLens),
    constantsCall("no field of view", 0, {.fovY = 0.0, .aspect = 1.0}),
    constantsCall("a field of view of half a turn", 0, {.fovY = std::numbers::pi, .aspect = 1.0}),
    constantsCall("a field of view that is no number", 0, {.fovY = kNan, .aspect = 1.0}),
    constantsCall("no width", 0, {.fovY = 1.0, .aspect = 0.0}),
    constantsCall("an infinite width", 0, {.fovY = 1.0, .aspect = HUGE_VAL}),
    constantsCall("a width that float32 cannot divide by", 0, {.fovY = 1.0, .aspect = 1e-40}),
    constantsCall("a field of view that float32 cannot divide by", 0, {.fovY = 1e-39, .aspect = 1.0}),
    {"advice's scene", [] { return messageOf(tryAdvise({.scene = kFarAway})); },
     [] { advise({.scene = kFarAway}); }},
};

TEST(Refusal, SaysWhatTheExceptionSays) {
    for (const BadCall& call : kBadCalls) {
        const std::optional<std::string> refusal = call.refused();
        ASSERT_TRUE(refusal) << call.what;
        EXPECT_EQ(test::inputErrorOf(call.thrown, "accepted"), *refusal) << call.what;
    }
}

/// A mapping that is no preset is a technique with a split alone.
TEST(Refusal, OfAMappingNamesTheTechnique) {
    EXPECT_EQ(tryNamedTechnique("anchored-reversed").refusal().message,
              "technique 'anchored-reversed' lacks a split, as in anchored-reversed/none");
    EXPECT_TRUE(tryNamedTechnique("anchored-reversed/none"));
}

TEST(Refusal, OfAnotherNumberOfMeasurements) {
    const AdviceQuestion question{.scene = {.footprintSlope = 1e-3}};
    EXPECT_TRUE(tryAdvise(question));
    EXPECT_FALSE(tryAdvise(question, {}));
    EXPECT_THROW(advise(question, {}), base::InputError);
}

TEST(Refusal, GoodCallsGiveTheSameBothWays) {
    EXPECT_EQ(tryNamedTechnique("cdr")->technique, namedTechnique("cdr").technique);
    EXPECT_EQ(*tryParseTechnique("anchored"), parseTechnique("anchored"));
    EXPECT_EQ(*tryThesisSeparationView(Mapping::log, kOneCascade, 24, 1.5),
              thesisSeparationView(Mapping::log, kOneCascade, 24, 1.5));
    EXPECT_EQ(tryCascadeConstants(Mapping::anchored, kOneCascade, 0, kLens)->projectionX,
              cascadeConstants(Mapping::anchored, kOneCascade, 0, kLens).projectionX);
    EXPECT_EQ(*tryParseSplit("at:1,2"), parseSplit("at:1,2"));
    EXPECT_EQ(tryMakeCascades(SplitCount{3}, kContext)->size(), makeCascades(SplitCount{3}, kContext).size());
}

} // namespace

} // namespace cdr::depth
