#include "../fixture.h"
#include "../snapping.h"

#include <scenes/cubes.h>
#include <scenes/mixed.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace cdr::render_test {

namespace {

using render::Snapping;

class InPlaneTest : public RenderTest {
  protected:
    /// Bits that vertices are rounded to: the device's own, which is 0 here, or emulated ones where it rounds none.
    std::vector<std::uint32_t> roundings() {
        return snapReach(device()) > 0.0 ? std::vector{0u} : std::vector{4u, 8u};
    }

    static render::RenderOptions optionsFor(std::uint32_t bits, Snapping snapping) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.snapBits = bits;
        options.snapping = snapping;
        return options;
    }
};

TEST_F(InPlaneTest, FacetsStayInTheirPlanes) {
    for (const std::uint32_t bits : roundings()) {
        const double promised = halfSubPixel(bits > 0 ? bits : device().info().subPixelBits);
        EXPECT_GT(measureReach(device(), bits, Snapping::byDevice), 0.5 * promised) << bits;
        EXPECT_LT(measureReach(device(), bits, Snapping::inPlane), 0.02 * promised + 1e-4) << bits;
    }
}

/// What a material needs of its shaders changes nothing in that.
TEST_F(InPlaneTest, SoDoThoseOfAnyMaterial) {
    scene::Scene scene = boxScene();
    scene::Material& material = scene.materials[0];
    material.doubleSided = true;
    material.alphaMode = scene::AlphaMode::mask;
    material.alphaCutoff = 0.0f;
    const scene::SceneSetup mixed = scenes::makeMixed();
    scene.instances = mixed.scene.instances;
    scene.materials.push_back(material);
    const scene::Camera camera = mixed.path.at(0);
    const measure::TruthImage truth = truthOf(scene, camera, 1440, 810);
    for (const std::uint32_t bits : roundings()) {
        const auto wrongWith = [&](Snapping snapping) {
            render::RenderOptions options = optionsFor(bits, snapping);
            options.width = truth.width;
            options.height = truth.height;
            return measure::countWrong(draw(scene, camera, options).ids(), truth).wrong;
        };
        EXPECT_LE(wrongWith(Snapping::inPlane), 2u);
        EXPECT_GT(wrongWith(Snapping::byDevice), 1'000u);
    }
}

/// Gaps that are narrower than what rounding tilts faces by.
TEST_F(InPlaneTest, AnchoredDepthOrdersWhatRoundingSwaps) {
    const scene::SceneSetup setup = scenes::makeMixed();
    const scene::Camera camera = setup.path.at(0);
    const render::GpuScene gpuScene(device(), setup.scene);
    measure::WrongPixels byDevice; // at some sizes none
    for (const glm::uvec2 size : {glm::uvec2(480, 270), glm::uvec2(800, 450), glm::uvec2(1440, 810)}) {
        const measure::TruthImage truth = truthOf(setup.scene, camera, size.x, size.y);
        for (const std::uint32_t bits : roundings()) {
            const auto wrongWith = [&](Snapping snapping) {
                render::RenderOptions options = optionsFor(bits, snapping);
                options.width = size.x;
                options.height = size.y;
                return measure::countWrong(draw(setup.scene, gpuScene, camera, options).ids(), truth);
            };
            byDevice += wrongWith(Snapping::byDevice);
            const measure::WrongPixels inPlane = wrongWith(Snapping::inPlane);
            EXPECT_GT(inPlane.pixels, 10'000u);
            // A facet may show beyond its crease, within half a sub-pixel.
            EXPECT_LE(inPlane.wrong, 2u) << size.x << " " << bits;
        }
    }
    EXPECT_GT(byDevice.wrong, 100u);
}

/// Seen from the edge, a facet's plane leaves its object within a sub-pixel.
TEST_F(InPlaneTest, NoSurfaceLeavesItsObject) {
    constexpr double kAtView = 20.0;
    scene::Scene scene = boxScene();
    for (int i = 0; i < 77; ++i) {
        const glm::dvec3 place(1.6 * (i % 11 - 5), 1.4 * (i / 11 - 3), -kAtView);
        const double tilt = 1e-3 * std::pow(1.03, i); // radians by which its right side faces the eye
        const glm::dvec3 toEye = glm::normalize(-place);
        const glm::dvec3 across = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), toEye));
        const double turn = std::asin(0.5 / glm::length(place) + tilt);
        const glm::dvec3 right = std::cos(turn) * across + std::sin(turn) * toEye;
        const glm::dvec3 up = glm::cross(toEye, across);
        addBox(scene, place, glm::mat3(glm::dmat3(right, up, glm::cross(right, up))));
    }
    const scene::Camera camera{.fovY = 0.5, .nearView = 1.0, .farView = 100.0};
    for (const std::uint32_t bits : snapReach(device()) > 0.0 ? std::vector{0u} : std::vector{1u, 8u}) {
        render::RenderOptions options = optionsFor(bits, Snapping::inPlane);
        options.technique = depth::parseTechnique("reversed"); // no cascade cuts off what leaves
        const render::Frame frame = draw(scene, camera, options);
        options.snapping = Snapping::byDevice;
        const render::Frame byDevice = draw(scene, camera, options);
        double farthest = 0.0;
        std::size_t drawn = 0;
        std::size_t unlike = 0; // where a corner is as near to two sub-pixels
        for (std::uint32_t y = 0; y < frame.height(); ++y) {
            for (std::uint32_t x = 0; x < frame.width(); ++x) {
                unlike += frame.id(x, y) != byDevice.id(x, y) ? 1 : 0;
                if (frame.id(x, y) != 0) {
                    farthest = std::max(farthest, std::abs(frame.distanceView(x, y) - kAtView));
                    ++drawn;
                }
            }
        }
        EXPECT_GT(drawn, 20'000u);
        EXPECT_LT(unlike, 5u) << bits;
        EXPECT_LT(farthest, std::numbers::sqrt3) << bits; // their radius, and once more
    }
}

TEST_F(InPlaneTest, EachWayToDrawShowsOnePicture) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const scene::Camera camera = setup.path.at(7);
    const render::RenderOptions plain = optionsFor(4, Snapping::inPlane);
    const std::string expected = hashOf(draw(setup.scene, camera, plain));
    EXPECT_NE(expected, hashOf(draw(setup.scene, camera, optionsFor(4, Snapping::byDevice))));
    expectOnePicture(setup.scene, camera, plain);
    render::RenderOptions culling = plain;
    culling.occlusionCulling = true;
    EXPECT_EQ(hashOf(draw(setup.scene, camera, culling)), expected);
}

TEST_F(InPlaneTest, SubPixelsFollowThePicturesSize) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const scene::Camera camera = setup.path.at(7);
    render::RenderOptions options = optionsFor(0, Snapping::inPlane);
    SoleRenderer renderer(device(), setup.scene, options);
    renderer.submit(camera);
    options.width = 333;
    options.height = 111;
    renderer.resize(options.width, options.height);
    EXPECT_EQ(hashOf(renderer.render(camera)), hashOf(draw(setup.scene, camera, options)));
}

/// Normals that are not those of the triangles say nothing of planes.
TEST_F(InPlaneTest, FalseNormalsMoveNothing) {
    scene::Scene scene = boxScene();
    for (scene::Vertex& vertex : scene.meshes[0].vertices) {
        vertex.normal = glm::normalize(vertex.normal + glm::vec3(0.3f, 0.2f, 0.1f));
    }
    addBox(scene, {0.3, 0.2, -5.0});
    const scene::Camera camera{.fovY = 0.5, .nearView = 1.0, .farView = 100.0};
    EXPECT_EQ(hashOf(draw(scene, camera, optionsFor(0, Snapping::inPlane))),
              hashOf(draw(scene, camera, optionsFor(0, Snapping::byDevice))));
}

TEST_F(InPlaneTest, FacetsThatShareCornersAreRefused) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0});
    for (const render::SurfacePath path : {render::SurfacePath::visibility, render::SurfacePath::lit}) {
        render::RenderOptions options = optionsFor(0, Snapping::inPlane);
        options.surface = path;
        EXPECT_NE(refusalOf(scene, options).find("snapping by-device"), std::string::npos);
        options.snapping = Snapping::byDevice;
        EXPECT_EQ(refusalOf(scene, options), "none");
    }
}

} // namespace

} // namespace cdr::render_test
