#include "../fixture.h"

#include <algorithm>
#include <cmath>

namespace cdr::render_test {

namespace {

using render::Frame;

/// A value in [0, 1] as sRGB in 0 to 255 (IEC 61966-2-1), not rounded.
double srgb(double linear) {
    const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return 255.0 * std::clamp(encoded, 0.0, 1.0);
}

/// What the G-buffer makes of an albedo: eight bits of its square root.
double stored(double albedo) {
    const double root = std::round(255.0 * std::sqrt(albedo)) / 255.0;
    return root * root;
}

class AnchoredShadingTest : public RenderTest {
  protected:
    AnchoredShadingTest() {
        m_scene.materials[0].baseColorFactor = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f);
        m_scene.ambient = glm::vec3(0.02f);
        addBox(m_scene, kCentre);
        // A hand's breadth off the face that looks at the camera, so that light varies all over it.
        m_scene.lights = {{.position = kCentre + glm::dvec3(0.1, 0.15, 0.65), .halfDistance = 0.3}};
    }

    /// The camera 10^6 units in front of the cube's face, which fills the picture's height.
    static scene::Camera camera() {
        return {.position = kCentre + glm::dvec3(0.0, 0.0, 1e6),
                .fovY = 0.98e-6,
                .nearView = 0.001,
                .farView = 2e6};
    }

    /// Largest difference between the picture and float64 shading of the exact surface, of 255. With `banding` also
    /// how often brightness steps back along a row or column that leads straight away from the light.
    struct Error {
        double worst = 0.0;
        std::size_t pixels = 0;
        std::size_t stepsBack = 0;
    };
    Error errorOf(const Frame& frame) const {
        Error error;
        const scene::PointLight& light = m_scene.lights[0];
        const double half = light.halfDistance * light.halfDistance;
        const double tanY = std::tan(0.5 * frame.camera.fovY);
        const double w = 1e6 - 0.5;
        for (std::uint32_t y = 0; y < frame.height(); ++y) {
            for (std::uint32_t x = 0; x < frame.width(); ++x) {
                const double right = tanY * w * (2.0 * (x + 0.5) - frame.width()) / frame.height();
                const double up = tanY * w * (1.0 - 2.0 * (y + 0.5) / frame.height());
                if (frame.id(x, y) == 0 || std::abs(right) > 0.499 || std::abs(up) > 0.499) {
                    continue;
                }
                const glm::dvec3 toLight = light.position - (kCentre + glm::dvec3(right, up, 0.5));
                const double squared = glm::dot(toLight, toLight);
                const double lit = 0.02 + toLight.z / std::sqrt(squared) * half / (half + squared);
                const double expected = srgb(stored(0.8) * lit);
                error.worst = std::max(error.worst, std::abs(frame.color.at(x, y)[0] - expected));
                ++error.pixels;
                const double beyond = right - (light.position.x - kCentre.x);
                if (x > 0 && beyond > 0.01 && frame.color.at(x, y)[0] > frame.color.at(x - 1, y)[0]) {
                    ++error.stepsBack;
                }
            }
        }
        return error;
    }

    static constexpr glm::dvec3 kCentre{123'456.75, -7'654.5, 9'876.25};
    scene::Scene m_scene = boxScene();
};

TEST_F(AnchoredShadingTest, LightOnACubeAMillionUnitsAwayHasNoBands) {
    for (const depth::Mapping mapping : {depth::Mapping::anchored, depth::Mapping::anchoredReversed}) {
        const auto technique = depth::Technique{mapping, depth::SplitFitted{}, depth::DepthFormat::d32f};
        const Error error = errorOf(draw(m_scene, camera(), smallOptions(technique)));
        EXPECT_GT(error.pixels, 60'000u);
        EXPECT_LE(error.worst, 1.0) << nameOf(mapping); // half of it is the picture's own rounding
        EXPECT_EQ(error.stepsBack, 0u) << nameOf(mapping);
    }
}

/// Float32 view distances step by 1/16 there, a tenth of the way to the light.
TEST_F(AnchoredShadingTest, FloatDistancesWouldShowIt) {
    const Error error = errorOf(draw(m_scene, camera(), smallOptions(depth::parseTechnique("reversed"))));
    EXPECT_GT(error.pixels, 60'000u);
    EXPECT_GT(error.worst, 4.0);
}

/// Positions and normals from the frame are what shading elsewhere would start from.
TEST_F(AnchoredShadingTest, PickedPositionsAreAsSmooth) {
    const Frame frame = draw(m_scene, camera(), smallOptions(depth::parseTechnique("anchored")));
    for (std::uint32_t x = 120; x < 360; ++x) {
        const auto pick = frame.pick(x, 135);
        ASSERT_TRUE(pick.has_value());
        EXPECT_NEAR(pick->position.z, kCentre.z + 0.5, 1e-6);
    }
}

} // namespace

} // namespace cdr::render_test
