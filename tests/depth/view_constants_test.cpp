#include <cdr/depth/cascade.h>
#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/mapping.h>
#include <cdr/depth/view_constants.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace cdr::depth {

namespace {

TEST(ViewConstants, PairsKeep48Bits) {
    const ViewAxes axes{.eye = {1.1e9, -2.2e6, 3.3e-3},
                        .right = {0.6, 0.8, 0.0},
                        .up = {-0.48, 0.36, 0.8},
                        .forward = {0.64, -0.48, 0.6}};
    const ViewConstants made = viewConstants(axes);
    const auto expectPairs = [](const std::array<double, 3>& wanted, const std::array<float, 4>& values,
                                const std::array<float, 4>& rests) {
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const double sum = static_cast<double>(values[i]) + static_cast<double>(rests[i]);
            EXPECT_NEAR(sum, wanted[i], std::ldexp(std::abs(wanted[i]), -48));
        }
        EXPECT_EQ(values[3], 0.0f);
        EXPECT_EQ(rests[3], 0.0f);
    };
    expectPairs(axes.eye, made.eye, made.eyeRest);
    expectPairs(axes.right, made.right, made.rightRest);
    expectPairs(axes.up, made.up, made.upRest);
    expectPairs(axes.forward, made.forward, made.forwardRest);
}

/// Devices may take subnormal numbers for 0. The thinnest of these cascades is as thin as float32 resolves.
TEST(CascadeConstants, AreNormalFloatsAtTheEndsOfTheRange) {
    const Cascades ranges{{kMinView, kMinView * (1.0 + 0x1p-23)},
                          {kMinView, kMinView * kMaxFarOverNear},
                          {kMaxView * (1.0 - 0x1p-23), kMaxView},
                          {kMaxView / kMaxFarOverNear, kMaxView},
                          {kMinView, 10.0 * kMinView},
                          {0.1 * kMaxView, kMaxView}};
    for (const Cascade& range : ranges) {
        for (const Mapping mapping : kMappings) {
            for (const FarEnd farEnd : {FarEnd::open, FarEnd::closed}) {
                const CascadeConstants made =
                    cascadeConstants(mapping, {range}, 0, {.fovY = 1.0, .aspect = 1.5}, farEnd);
                for (const float constant : {made.anchorView, made.scale, made.offset, made.nearAhead,
                                             made.farAhead, made.projectionX, made.projectionY}) {
                    EXPECT_TRUE(constant == 0.0f || std::isnormal(constant))
                        << nameOf(mapping) << " " << range.nearView << " " << range.farView << " "
                        << constant;
                }
                EXPECT_TRUE(made.scale != 0.0f || farEnd == FarEnd::open) << nameOf(mapping);
                EXPECT_LT(made.nearAhead, made.farAhead) << nameOf(mapping);
            }
        }
    }
    for (const auto& [nearView, farView] : {std::pair{kMinView, kMinView * kMaxFarOverNear},
                                            {10.0 * kMaxView / kMaxFarOverNear, kMaxView},
                                            {kMinView, 10.0 * kMinView}}) {
        EXPECT_FALSE(rangeProblem(nearView, farView)) << nearView << " " << farView;
    }
}

} // namespace

} // namespace cdr::depth
