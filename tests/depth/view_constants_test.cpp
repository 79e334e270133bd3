#include <cdr/depth/view_constants.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

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

} // namespace

} // namespace cdr::depth
