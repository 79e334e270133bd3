#include "../fixture.h"
#include "compute.h"

#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/make_cascades.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <span>
#include <vector>

namespace cdr::render_test {

namespace {

using Vec4 = std::array<float, 4>;

/// As recipe.comp takes and makes them.
struct Ahead {
    float ahead;
    float cascade;
    float touchView;
    float slopeX; ///< x / w of a vertex
};
struct Made {
    Vec4 pairAndLog;
    Vec4 straight;
    Vec4 logarithmic;
    Vec4 tangent;
    Vec4 inside;
    Vec4 inPlane;
};

double zNdcOf(const Vec4& clip) {
    return static_cast<double>(clip[2]) / static_cast<double>(clip[3]);
}

/// A cascade of a mapping, and view distances in it and beyond its ends, as float64 has them.
struct Case {
    depth::Mapping mapping;
    depth::Cascade clip;
    depth::DepthRange range;
    depth::ClipTerms terms;
    depth::CascadeConstants constants;
    std::vector<double> distancesView;
    std::vector<float> slopesX;
    double touchView;

    Case(depth::Mapping mapping_, const depth::Cascade& ends, std::mt19937_64& random)
        : mapping(mapping_),
          clip(depth::clipRange(mapping, {ends}, 0)),
          range(depth::depthRange(mapping, depth::Cascades{ends}, 0)),
          terms(depth::clipTerms(range)),
          constants(depth::cascadeConstants(mapping, {ends}, 0, {.fovY = 1.0, .aspect = 1.0})),
          touchView(std::sqrt(ends.nearView * ends.farView)) {
        std::uniform_real_distribution<double> exponent(-0.05, 1.05);
        for (int i = 0; i < 200; ++i) {
            distancesView.push_back(ends.nearView * std::pow(ends.farView / ends.nearView, exponent(random)));
            slopesX.push_back(static_cast<float>(0.5 * exponent(random)));
        }
    }
};

std::vector<Case> allCases() {
    std::mt19937_64 random(1968);
    std::vector<Case> cases;
    for (const depth::Mapping mapping : depth::kMappings) {
        for (const depth::Cascade& ends : std::initializer_list<depth::Cascade>{
                 {0.1, 100.3}, {1.0 / 3.0, 1e6}, {3.1e5, 4.7e7}, {7.03e8, 7.1e8}}) {
            if (ends.farView > 2.0 * ends.nearView || !depth::isLog(mapping)) {
                cases.emplace_back(mapping, ends, random);
            }
        }
    }
    return cases;
}

void expectPair(const Made& made, const Case& of, double ahead) {
    const double wanted = of.terms.anchorView + ahead;
    const double value = made.pairAndLog[0];
    const double rest = made.pairAndLog[1];
    const double coarsest = std::max(std::abs(of.terms.anchorView), std::abs(wanted));
    ASSERT_NEAR(value + rest, wanted, std::ldexp(coarsest, -47));
    ASSERT_EQ(made.pairAndLog[0], static_cast<float>(value + rest)); // the rest is less than half a step
}

void expectDepth(const Made& made, const Case& of, double ahead, double distanceView) {
    const double wanted = depth::zNdcAt(of.range, distanceView);
    if (!depth::isLog(of.mapping)) {
        const double z = std::abs(of.terms.scale * ahead) + std::abs(of.terms.offset);
        const double w = of.terms.anchorView + distanceView; // what is added up to it
        ASSERT_NEAR(zNdcOf(made.straight), wanted,
                    std::ldexp((z + w * std::abs(wanted)) / distanceView, -22));
        ASSERT_EQ(made.straight[0], 0.25f * of.constants.projectionX);
        ASSERT_EQ(made.straight[1], -0.5f * of.constants.projectionY);
        return;
    }
    // What Vulkan allows of log() near 1 and elsewhere, and the roundings beside it.
    const double tolerance =
        std::ldexp(of.terms.offset, -20) + std::ldexp(std::abs(std::log(distanceView)), -21);
    ASSERT_NEAR(made.pairAndLog[2], wanted, tolerance);
    ASSERT_NEAR(zNdcOf(made.logarithmic), wanted, tolerance);
    const double tangent =
        depth::zNdcAt(of.range, of.touchView) - 2e-6 + of.terms.offset * (1.0 - of.touchView / distanceView);
    ASSERT_NEAR(zNdcOf(made.tangent), tangent,
                tolerance * (1.0 + of.touchView / distanceView)); // 0 where it touches, less the margin
    ASSERT_LE(zNdcOf(made.tangent), made.pairAndLog[2]);
}

void expectCut(const Made& made, const Case& of, double ahead, double distanceView) {
    const double inside[]{distanceView - of.clip.nearView, of.clip.farView - distanceView};
    for (std::size_t end = 0; end < 2; ++end) {
        const double anchored = (end == 0 ? of.clip.nearView : of.clip.farView) - of.terms.anchorView;
        const double tolerance = std::ldexp(std::abs(ahead) + std::abs(anchored), -23);
        ASSERT_NEAR(made.inside[end], inside[end], tolerance);
        if (std::abs(inside[end]) < tolerance) {
            return; // too close to tell on which side
        }
    }
    ASSERT_EQ(made.pairAndLog[3], inside[0] < 0.0 || inside[1] < 0.0 ? 1.0f : 0.0f);
    ASSERT_NEAR(made.inside[2], distanceView - 0.5 * of.clip.nearView,
                std::ldexp(std::max(of.terms.anchorView, distanceView) + of.clip.nearView, -22));
    ASSERT_EQ(made.inside[3], 1.0f);
}

/// A vertex of the plane that recipe.comp names.
void expectInPlane(const Made& made, const Case& of, const Ahead& given) {
    const float distanceView = made.pairAndLog[0];
    const glm::dvec3 before(given.slopeX * distanceView, -0.5f * distanceView, given.ahead);
    const glm::dvec3 after(made.inPlane[0], made.inPlane[1], made.inPlane[2]);
    const double roundings =
        std::ldexp(std::abs(static_cast<double>(given.ahead)) + static_cast<double>(distanceView), -22);
    ASSERT_NEAR(glm::dot(glm::dvec3(0.75, 0.5, 1.0), after - before), 0.0, roundings);
    const double perSlope[]{1e4 * of.constants.projectionX, 1e4 * of.constants.projectionY};
    const double afterView = static_cast<double>(of.constants.anchorView) + after.z;
    const double unlike = std::ldexp(std::abs(afterView) + of.terms.anchorView, -22) / afterView;
    for (int axis = 0; axis < 2; ++axis) {
        const double subPixel = after[axis] / afterView * perSlope[axis];
        ASSERT_NEAR(subPixel, std::round(subPixel), unlike * std::abs(subPixel));
        ASSERT_NEAR(subPixel, before[axis] / static_cast<double>(distanceView) * perSlope[axis],
                    0.5 + unlike * std::abs(subPixel));
    }
    ASSERT_EQ(made.inPlane[3], 1.0f);
}

using RecipeTest = RenderTest;

/// Every function of the recipe, on the device, gives what float64 does, as finely as the page says, for each mapping. A
/// metric distance as a pair of floats, which one float misses by a million times as much. HLSL agrees with GLSL to the bit.
TEST_F(RecipeTest, EachFunctionGivesWhatFloat64DoesInGlslAndHlsl) {
    const std::vector<Case> cases = allCases();
    std::vector<depth::CascadeConstants> constants;
    std::vector<Ahead> aheads;
    for (const Case& of : cases) {
        for (std::size_t i = 0; i < of.distancesView.size(); ++i) {
            aheads.push_back({static_cast<float>(of.distancesView[i] - of.terms.anchorView),
                              static_cast<float>(constants.size()), static_cast<float>(of.touchView),
                              of.slopesX[i]});
        }
        constants.push_back(of.constants);
    }
    const auto made =
        compute<Made>(device(), CDR_HOST_RECIPE, std::span<const depth::CascadeConstants>(constants),
                      std::span<const Ahead>(aheads), aheads.size());
    double mostRest = 0.0;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < made.size(); ++i) {
        const Case& of = cases[i / cases[0].distancesView.size()];
        const double ahead = aheads[i].ahead; // what the device is given, rounded
        const double distanceView = of.terms.anchorView + ahead;
        SCOPED_TRACE(testing::Message() << nameOf(of.mapping) << " at " << distanceView);
        expectPair(made[i], of, ahead);
        expectDepth(made[i], of, ahead, distanceView);
        expectCut(made[i], of, ahead, distanceView);
        expectInPlane(made[i], of, aheads[i]);
        if (HasFatalFailure()) {
            return;
        }
        mostRest = std::max(mostRest, std::abs(static_cast<double>(made[i].pairAndLog[1])));
        outside += made[i].pairAndLog[3] != 0.0f ? 1 : 0;
    }
    EXPECT_GT(mostRest, 10.0); // of 7e8, whose floats are 64 apart
    EXPECT_GT(outside, made.size() / 50);
    EXPECT_LT(outside, made.size() / 5);
    const auto byHlsl =
        compute<Made>(device(), CDR_HOST_RECIPE_HLSL, std::span<const depth::CascadeConstants>(constants),
                      std::span<const Ahead>(aheads), aheads.size());
    EXPECT_EQ(std::memcmp(byHlsl.data(), made.data(), made.size() * sizeof(Made)), 0);
}

} // namespace

} // namespace cdr::render_test
