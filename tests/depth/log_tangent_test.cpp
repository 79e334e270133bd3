#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

// The shader include is C++ as well, so its arithmetic is tested here.
namespace shader {
float max(float a, double b) {
    return glm::max(a, static_cast<float>(b));
}
using glm::vec2;
using glm::vec4;
using std::abs;
/// What it errs by, as a share of the most that Vulkan allows. So it is the worst device's.
float logError = 0.0f;
float log(float x) {
    const float exact = std::log(x);
    return exact + logError * (x >= 0.5f && x <= 2.0f ? 0x1p-21f : 3.0f * 0x1p-23f * std::abs(exact));
}
#define CDR_PRECISE // a word of GLSL
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#include "../../shaders/public/cdr_depth.glsl"
#pragma GCC diagnostic pop
} // namespace shader

/// The depth that a rasteriser interpolates from the tangent, and the depth that the fragment shader writes.
struct Depths {
    float tangent;
    float written;
};

/// logError: upwards of the tangent's logarithm, downwards of the other.
Depths depthsAt(float distanceView, float touchView, const shader::CdrDepth& depth, float logError = 0.0f) {
    shader::logError = logError;
    const glm::vec4 clip = shader::cdrClipPositionLogTangent(glm::vec2(0.0f), distanceView, touchView, depth);
    shader::logError = -logError;
    return {clip.z / clip.w, shader::cdrLogDepth(distanceView, depth)};
}

shader::CdrDepth logDepth(double nearView, double farView) {
    return {0.0f, static_cast<float>(1.0 / nearView), static_cast<float>(1.0 / std::log(farView / nearView))};
}

/// Where depth_greater does not hold, the picture is undefined.
TEST(LogTangent, IsNeverAboveTheDepthThatIsWritten) {
    std::mt19937_64 random(2013);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (const auto& [nearView, farView] : {std::pair{0.001, 2e6},
                                            {0.1, 1e5},
                                            {1.0, 1000.0},
                                            {1e6, 1e9},
                                            {3.0, 6.0},
                                            {1.0, 1.4},
                                            {1e3, 1.02e3}}) {
        const shader::CdrDepth depth = logDepth(nearView, farView);
        const auto distance = [&, n = nearView, f = farView] {
            return static_cast<float>(n * std::pow(f / n, part(random)));
        };
        for (int i = 0; i < 100'000; ++i) {
            const float distanceView = distance();
            const float touchView = distance();
            const Depths depths = depthsAt(distanceView, touchView, depth, 1.0f);
            ASSERT_LE(depths.tangent, depths.written) << distanceView << " touching at " << touchView;
        }
    }
}

/// Otherwise early tests would reject nothing: within a hundredth of the distance the tangent is close.
TEST(LogTangent, TouchesWhereItIsAskedTo) {
    const shader::CdrDepth depth = logDepth(0.1, 1e5);
    for (const float touchView : {0.2f, 30.0f, 9e4f}) {
        const Depths depths = depthsAt(1.01f * touchView, touchView, depth);
        EXPECT_NEAR(depths.tangent, depths.written, 1e-5);
    }
}

} // namespace
