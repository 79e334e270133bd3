#include "fixture.h"

#include <scenes/sheets.h>

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace cdr::render_test {

namespace {

/// A scene and its camera, so many times as large as another one. A power of two, so that no number is rounded elsewhere.
struct ScaledScene {
    scene::Scene scene;
    scene::Camera camera;
};

enum class Look { facets, round, glass };

/// Boxes, skewed, and how they look: with facets, shaded as round ones, or two of them as glass too.
/// @param hand -1.0 mirrors two of them
ScaledScene scaledBy(double scale, Look look, float hand = -1.0f) {
    ScaledScene made{.scene = boxScene(),
                     .camera = {.fovY = 1.0, .nearView = 0.1 * scale, .farView = 100.0 * scale}};
    scene::Scene& scene = made.scene;
    scene.lights.front() = {.position = scale * glm::dvec3(5.0, 9.0, 7.0),
                            .color = glm::vec3(1.0f),
                            .halfDistance = 20.0 * scale};
    scene.meshes.push_back(scene.meshes.front());
    for (scene::Vertex& vertex : scene.meshes.back().vertices) {
        vertex.normal = look == Look::facets ? vertex.normal : glm::normalize(vertex.position);
    }
    scene.materials.push_back({.name = "glass", .baseColorFactor = {0.3f, 0.9f, 0.5f, 0.6f}});
    scene.materials.back().alphaMode =
        look == Look::glass ? scene::AlphaMode::blend : scene::AlphaMode::opaque;
    const glm::mat3 skewed(glm::vec3(0.9f, 0.2f, 0.1f), glm::vec3(0.3f, 1.0f, 0.2f),
                           glm::vec3(-0.1f, 0.4f, 0.7f));
    const glm::mat3 mirrored(hand * skewed[0], skewed[1], skewed[2]);
    const auto size = static_cast<float>(scale);
    scene::addInstance(scene, 1, 0, 0, scale * glm::dvec3(-0.6, 0.0, -3.0), size * mirrored);
    scene::addInstance(scene, 0, 1, 1, scale * glm::dvec3(0.6, 0.2, -2.5), size * mirrored);
    scene::addInstance(scene, 1, 1, 2, scale * glm::dvec3(0.6, -0.7, -3.0), size * skewed);
    return made;
}

/// Pixels that show another object, or another normal.
std::size_t differingPixels(const render::Frame& a, const render::Frame& b) {
    std::size_t differ = 0;
    for (std::uint32_t y = 0; y < a.height(); ++y) {
        for (std::uint32_t x = 0; x < a.width(); ++x) {
            const auto one = a.pick(x, y);
            const auto other = b.pick(x, y);
            const bool isAlike =
                one.has_value() == other.has_value() &&
                (!one || (one->object == other->object && glm::dot(one->normal, other->normal) > 0.9999));
            differ += isAlike ? 0 : 1;
        }
    }
    return differ;
}

class ScaledSceneTest : public RenderTest {
  protected:
    /// Whether the device draws boxes that are no mirrors where they are. Some form products of three w, which are no
    /// floats: they lose triangles below 2^-46 units, and interpolate nothing above 2^38.
    bool drawsAt(int power, const render::RenderOptions& options) {
        const auto frameAt = [&](double scale) {
            const ScaledScene made = scaledBy(scale, Look::facets, 1.0f);
            return draw(made.scene, made.camera, options);
        };
        const double scale = std::ldexp(1.0, power);
        const render::Frame plain = frameAt(1.0);
        const render::Frame scaled = frameAt(scale);
        for (std::uint32_t y = 0; y < plain.height(); ++y) {
            for (std::uint32_t x = 0; x < plain.width(); ++x) {
                const bool isAlike = plain.id(x, y) == scaled.id(x, y) &&
                                     (plain.id(x, y) == 0 || std::abs(scaled.distanceView(x, y) / scale -
                                                                      plain.distanceView(x, y)) < 1e-3);
                if (!isAlike) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Skips a test that drew nothing, which lavapipe, that draws all cases, may not.
    void expectDrawn(std::size_t drawn, std::size_t all) {
        if (device().info().name.find("llvmpipe") != std::string::npos) {
            EXPECT_EQ(drawn, all);
        } else if (drawn == 0) {
            GTEST_SKIP() << "the device draws no scene that is so small or large";
        }
    }
};

/// Products of three entries of a basis are no float32 numbers at either end.
TEST_F(ScaledSceneTest, SidesAndNormalsAreThoseOfTheSceneItself) {
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    std::size_t drawn = 0;
    for (const render::SurfacePath surface :
         {render::SurfacePath::gbuffer, render::SurfacePath::visibility}) {
        options.surface = surface;
        const Look look = surface == render::SurfacePath::gbuffer ? Look::round : Look::facets;
        const ScaledScene plain = scaledBy(1.0, look);
        const render::Frame expected = draw(plain.scene, plain.camera, options);
        for (const int power : {-85, -50, 50}) {
            if (!drawsAt(power, options)) {
                continue;
            }
            ++drawn;
            const ScaledScene scaled = scaledBy(std::ldexp(1.0, power), look);
            EXPECT_LE(differingPixels(draw(scaled.scene, scaled.camera, options), expected), 5u)
                << "2^" << power << " " << nameOf(surface);
        }
    }
    expectDrawn(drawn, 6);
}

TEST_F(ScaledSceneTest, ColoursOfBlendedSurfacesAreThoseOfTheSceneItself) {
    const render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    const ScaledScene plain = scaledBy(1.0, Look::glass);
    const auto expected = draw(plain.scene, plain.camera, options).color.pixels;
    std::size_t drawn = 0;
    for (const int power : {-50, 50}) {
        if (!drawsAt(power, options)) {
            continue;
        }
        ++drawn;
        const ScaledScene scaled = scaledBy(std::ldexp(1.0, power), Look::glass);
        const auto colors = draw(scaled.scene, scaled.camera, options).color.pixels;
        std::size_t differ = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                differ += std::abs(int{colors[i][channel]} - int{expected[i][channel]}) > 1 ? 1 : 0;
            }
        }
        EXPECT_LE(differ, 5u) << "2^" << power;
    }
    expectDrawn(drawn, 2);
}

/// A square in front of a wall, and a layer by which the wall is moved before it, or not quite. Products of two lengths are no
/// float32 numbers here.
TEST_F(ScaledSceneTest, LayersMoveByTheirOffset) {
    constexpr int kPower = -66;
    const double scale = std::ldexp(1.0, kPower);
    const render::RenderOptions options = smallOptions(depth::parseTechnique("standard"));
    const bool isDrawn = drawsAt(kPower, options);
    for (const double layer : isDrawn ? std::vector{0.7, 1.3} : std::vector<double>{}) {
        scene::Scene scene = boxScene();
        scene.meshes.push_back(scenes::makeSquare(static_cast<float>(scale)));
        scene.materials.push_back({.name = "layer", .layer = static_cast<float>(layer * scale)});
        scene::addInstance(scene, 1, 0, 0, {0.0, 0.0, -30.0 * scale}, glm::mat3(1.0f));
        scene::addInstance(scene, 1, 1, 1, {0.0, 0.0, -31.0 * scale}, glm::mat3(1.0f));
        const scene::Camera camera{.fovY = 0.05, .nearView = 0.1 * scale, .farView = 1000.0 * scale};
        EXPECT_EQ(draw(scene, camera, options).id(240, 135), layer > 1.0 ? 2u : 1u) << layer;
    }
    expectDrawn(isDrawn ? 1 : 0, 1);
}

/// Nor are squares of lengths.
TEST_F(ScaledSceneTest, FacetsStayInTheirPlanes) {
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    options.snapBits = 4;
    const auto distancesAt = [&](int power, render::Snapping snapping) {
        options.snapping = snapping;
        const double scale = std::ldexp(1.0, power);
        const ScaledScene made = scaledBy(scale, Look::facets);
        const render::Frame frame = draw(made.scene, made.camera, options);
        std::vector<double> distances;
        for (std::uint32_t y = 0; y < frame.height(); ++y) {
            for (std::uint32_t x = 0; x < frame.width(); ++x) {
                distances.push_back(frame.id(x, y) != 0 ? frame.distanceView(x, y) / scale : 0.0);
            }
        }
        return distances;
    };
    const auto unlike = [](const std::vector<double>& a, const std::vector<double>& b) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            count += std::abs(a[i] - b[i]) > 1e-5 ? 1 : 0;
        }
        return count;
    };
    const std::vector<double> expected = distancesAt(0, render::Snapping::inPlane);
    EXPECT_GT(unlike(distancesAt(0, render::Snapping::byDevice), expected), 1000u);
    std::size_t drawn = 0;
    for (const int power : {-70, 50}) {
        if (drawsAt(power, options)) {
            ++drawn;
            EXPECT_LE(unlike(distancesAt(power, render::Snapping::inPlane), expected), 5u) << "2^" << power;
        }
    }
    expectDrawn(drawn, 2);
}

/// So flat that, rounded to float32, the rows of its basis in view space do not say whether it is a mirror.
TEST_F(ScaledSceneTest, NormalsOfFlatInstancesKeepTheirSideHoweverTheCameraRolls) {
    scene::Scene scene = boxScene();
    scene.meshes.push_back(scenes::makeSquare(1.0f));
    const glm::dmat3 turned = glm::mat3_cast(glm::dquat(glm::dvec3(0.4, 0.7, 0.2)));
    const glm::dmat3 flat(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3e-9);
    scene::addInstance(scene, 1, 0, 0, glm::dvec3(0.0), glm::mat3(flat * turned));
    const glm::dvec3 eye(2.0, 1.5, 3.0);
    for (const auto submission : {render::Submission::secondaries, render::Submission::gpuDriven}) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"), 16, 9);
        options.submission = submission;
        if (submission == render::Submission::gpuDriven && !device().info().gpuDrivenMissing.empty()) {
            continue;
        }
        SoleRenderer renderer(device(), scene, options);
        for (int roll = 0; roll < 60; ++roll) {
            const glm::dvec3 up(std::cos(0.3 * roll), std::sin(0.3 * roll), 0.1);
            const render::Frame frame =
                renderer.render(scene::lookAlong({.fovY = 0.3}, eye, -glm::normalize(eye), up));
            ASSERT_EQ(frame.id(8, 4), 1u);
            EXPECT_GT(frame.normalView(8, 4).z, 0.5f) << roll;
        }
    }
}

} // namespace

} // namespace cdr::render_test
