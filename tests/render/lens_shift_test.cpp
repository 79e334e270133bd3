#include "fixture.h"
#include "steps.h"
#include "views/views_scene.h"

#include <cdr/scene/frustum.h>

#include <cmath>
#include <string>

namespace cdr::render_test {

namespace {

using render::Frame;

constexpr std::uint32_t kTileWidth = 120;
constexpr std::uint32_t kTileHeight = 68;

scene::Camera wideCamera() {
    return rigOf(scene::StereoMode::parallel).centre;
}

/// The lens of one of the four quarters of a camera's picture.
scene::Camera quarter(scene::Camera camera, std::uint32_t column, std::uint32_t row) {
    const scene::Frustum whole = scene::frustumOf(camera, 2 * kTileWidth, 2 * kTileHeight);
    camera.lensShift +=
        0.5 * glm::dvec2(column == 0 ? -whole.tanX : whole.tanX, row == 0 ? whole.tanY : -whole.tanY);
    camera.fovY = 2.0 * std::atan(0.5 * whole.tanY);
    return camera;
}

/// Boxes, shiny and blended ones among them.
scene::Scene variedScene() {
    scene::Scene scene = floorAndBoxes();
    scene.ambient = glm::vec3(0.2f);
    scene.materials.push_back(
        {.name = "shiny",
         .baseColorFactor = {0.8f, 0.5f, 0.2f, 1.0f},
         .metallicRoughness = scene::MetallicRoughness{.metallic = 0.7f, .roughness = 0.4f}});
    scene.materials.push_back(
        {.name = "glass", .baseColorFactor = {0.2f, 0.6f, 0.9f, 0.5f}, .alphaMode = scene::AlphaMode::blend});
    for (std::size_t i = 3; i < scene.instances.size(); i += 3) {
        scene.instances.material[i] = i % 2 == 0 ? 1 : 2;
    }
    return scene;
}

struct Difference {
    double ids = 0.0;    ///< share of pixels that show another object
    double colors = 0.0; ///< share of pixels whose colour differs by more than three steps
};

class LensShiftTest : public RenderTest {
  protected:
    /// How far the four quarters of a picture, each by a renderer of its own, are from the whole picture.
    Difference quartersBeside(const scene::Scene& scene, render::RenderOptions options) {
        options.width = 2 * kTileWidth;
        options.height = 2 * kTileHeight;
        const Frame whole = draw(scene, wideCamera(), options);
        options.width = kTileWidth;
        options.height = kTileHeight;
        Difference difference;
        for (std::uint32_t tile = 0; tile < 4; ++tile) {
            const std::uint32_t column = tile % 2;
            const std::uint32_t row = tile / 2;
            const Frame part = draw(scene, quarter(wideCamera(), column, row), options);
            for (std::uint32_t y = 0; y < kTileHeight; ++y) {
                for (std::uint32_t x = 0; x < kTileWidth; ++x) {
                    const std::uint32_t wholeX = column * kTileWidth + x;
                    const std::uint32_t wholeY = row * kTileHeight + y;
                    const int steps = largestStep(part.color.at(x, y), whole.color.at(wholeX, wholeY));
                    difference.ids += part.id(x, y) != whole.id(wholeX, wholeY) ? kPixel : 0.0;
                    difference.colors += steps > 3 ? kPixel : 0.0;
                }
            }
        }
        return difference;
    }
    void expectSame(const std::string& what, const scene::Scene& scene,
                    const render::RenderOptions& options) {
        const Difference difference = quartersBeside(scene, options);
        // What the device rounds at edges.
        EXPECT_LT(difference.ids, 0.004) << what;
        EXPECT_LT(difference.colors, 0.006) << what;
    }

  private:
    static constexpr double kPixel = 1.0 / (4.0 * kTileWidth * kTileHeight);
};

TEST_F(LensShiftTest, QuartersMakeThePicture) {
    const scene::Scene scene = variedScene();
    for (const depth::Technique& technique : presetTechniques()) {
        expectSame(nameOf(technique), scene, smallOptions(technique));
    }
    const depth::Technique anchored = depth::parseTechnique("anchored");
    for (const render::TargetsKind targets : render::kTargetsKinds) {
        render::RenderOptions options = smallOptions(anchored);
        options.targets = targets;
        expectSame(std::string(nameOf(targets)), scene, options);
    }
    for (const render::Submission submission : submissions()) {
        for (const bool culls : {false, true}) {
            render::RenderOptions options = smallOptions(anchored);
            options.submission = submission;
            options.occlusionCulling = culls;
            expectSame(std::string(nameOf(submission)), scene, options);
        }
    }
}

/// Options that read the ray through a pixel.
struct RayCase {
    std::string name;
    scene::Scene scene;
    render::RenderOptions options;
};

std::vector<RayCase> casesWithRays() {
    std::vector<RayCase> cases;
    const auto add = [&](const char* name) -> RayCase& {
        return cases.emplace_back(RayCase{.name = name,
                                          .scene = variedScene(),
                                          .options = smallOptions(depth::parseTechnique("anchored"))});
    };
    add("fog").options.effects.fog.visibility = 60.0;
    add("sky").scene.sky = scene::Sky{};
    add("shadows").options.shadows.method = render::ShadowMethod::anchored;
    add("plain shadows").options.shadows.method = render::ShadowMethod::plain;
    add("in plane").options.snapping = render::Snapping::inPlane;
    RayCase& lights = add("many lights");
    for (int i = 0; i < 6; ++i) {
        lights.scene.lights.push_back({.position = {3.0 * i - 9.0, 2.0, -8.0},
                                       .color = glm::vec3(0.5f),
                                       .halfDistance = 3.0,
                                       .range = 9.0});
    }
    return cases;
}

TEST_F(LensShiftTest, QuartersMakeThePictureWithEffects) {
    for (const RayCase& each : casesWithRays()) {
        expectSame(each.name, each.scene, each.options);
    }
}

TEST_F(LensShiftTest, QuartersMakeThePictureOfFacets) {
    for (const render::SurfacePath surface : {render::SurfacePath::visibility, render::SurfacePath::lit}) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.surface = surface;
        expectSame(std::string(nameOf(surface)), floorAndBoxes(), options);
    }
}

TEST_F(LensShiftTest, QuartersMakeThePictureOfBlendedSurfaces) {
    if (!device().info().hasFragmentStores) {
        GTEST_SKIP() << "the device lacks fragmentStoresAndAtomics";
    }
    expectSame("sorted", variedScene(), withSorting(smallOptions(depth::parseTechnique("anchored"))));
}

/// A quarter lacks what lies beyond its edges, which darkens little.
TEST_F(LensShiftTest, CornersAreAsDarkInAQuarter) {
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    const auto picture = [&] { return draw(variedScene(), wideCamera(), options).color; };
    const image::ImageRgba8 plain = picture();
    options.effects.occlusion.radius = 0.5;
    EXPECT_NE(picture(), plain) << "corners are dark";
    EXPECT_LT(quartersBeside(variedScene(), options).colors, 0.03);
    options.targets = render::TargetsKind::layers;
    options.effects.occlusion.perLayer = true;
    EXPECT_LT(quartersBeside(floorAndBoxes(), options).colors, 0.03);
}

TEST_F(LensShiftTest, PicksPointsOnTheRayOfThePixel) {
    const scene::Camera camera = quarter(wideCamera(), 1, 1);
    const render::RenderOptions options =
        smallOptions(depth::parseTechnique("anchored"), kTileWidth, kTileHeight);
    const Frame frame = draw(variedScene(), camera, options);
    const scene::Frustum frustum = scene::frustumOf(camera, kTileWidth, kTileHeight);
    const auto pick = frame.pick(kTileWidth - 1, kTileHeight - 1);
    ASSERT_TRUE(pick.has_value());
    const glm::dvec3 view = camera.toView(pick->position);
    const double halfPixel = 0.5 * frustum.footprintSlope;
    // The lens begins at the view axis, to the right and below.
    EXPECT_NEAR(view.x / -view.z, 2.0 * frustum.tanX - halfPixel, 1e-9);
    EXPECT_NEAR(view.y / -view.z, -2.0 * frustum.tanY + halfPixel, 1e-9);
}

TEST_F(LensShiftTest, PixelsAreThoseOfTheTruth) {
    const scene::Scene scene = floorAndBoxes();
    for (const glm::dvec2& shift : {glm::dvec2(0.3, -0.2), glm::dvec2(-2.0, -0.7), glm::dvec2(1e-4, 2e-4)}) {
        scene::Camera camera = wideCamera();
        camera.lensShift = shift;
        for (const char* technique : {"reversed", "anchored"}) {
            const Frame frame =
                draw(scene, camera, quarterOf(smallOptions(depth::parseTechnique(technique))));
            const measure::WrongPixels wrong = wrongIn(frame, scene, camera);
            EXPECT_GT(wrong.pixels, 1'000u) << shift.x;
            // Four sub-pixel bits move edges of the small boxes.
            const bool isCoarse = device().info().subPixelBits < 8;
            EXPECT_LE(wrong.wrong, isCoarse ? wrong.pixels / 200 : 0u) << technique << " " << shift.x;
            // A truth that looks elsewhere differs at what it takes for edges.
            EXPECT_LE(wrong.edgeWrong, isCoarse ? wrong.pixels / 20 : 15u) << technique << " " << shift.x;
        }
    }
}

} // namespace

} // namespace cdr::render_test
