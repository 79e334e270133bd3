#include "../fixture.h"
#include "../steps.h"

#include <cdr/base/error.h>
#include <cdr/measure/truth/layered_truth.h>

#include <algorithm>

namespace cdr::render_test {

namespace {

class AirTest : public RenderTest {
  protected:
    /// The largest difference to the truth, inside of surfaces and of background, 8-bit steps.
    int largestStep(const scene::Scene& scene, const scene::Camera& camera,
                    render::SurfacePath surface = render::SurfacePath::gbuffer) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"), 64, 36);
        options.surface = surface;
        options.effects.finish.toneMap = render::ToneMap::none;
        const measure::LayeredTruth truth = layersOf(scene, camera, options.width, options.height);
        return largestStepTo(truth, {}, draw(scene, camera, options).color);
    }
};

constexpr double kGround = 6'378'137.0;

/// The Earth's air, its centre below the origin, which is 2 m over the ground at 50 degrees north. The Sun is at 40 degrees.
scene::Scene airScene() {
    scene::Scene scene = boxScene();
    scene.lights.clear();
    scene.ambient = glm::vec3(0.4f);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.0, 0.766, -0.643));
    // What stretching along the axis makes as long as the radius.
    const double stretched = glm::length(glm::dvec3(0.0, 1.0, 0.0) + 1.0 / 297.0 * axis.y * axis);
    scene.air = scene::Air{.centre = {0.0, -2.0 - kGround / stretched, 0.0},
                           .axis = axis,
                           .flattening = 1.0 / 298.0,
                           .toSun = glm::normalize(glm::dvec3(-0.5, 0.84, 0.87)),
                           .sunlight = glm::vec3(4.0f)};
    return scene;
}

scene::Camera lookFrom(double height, const glm::dvec3& target, double fovY) {
    return scene::lookAt({.fovY = fovY, .nearView = 1.0, .farView = 1e8}, {0.0, height, 0.0}, target);
}

TEST_F(AirTest, SkiesRimsAndTheGroundAreAsInFloat64) {
    const scene::Scene scene = airScene();
    EXPECT_LE(largestStep(scene, lookFrom(0.0, {0.0, 1e4, -1e4}, 1.2)), 3) << "sky";
    EXPECT_LE(largestStep(scene, lookFrom(0.0, {-5e4, 2e3, -5e4}, 0.4)), 3) << "horizon";
    EXPECT_LE(largestStep(scene, lookFrom(1e4, {1e5, 0.0, 1e5}, 1.0)), 3) << "from an aircraft";
    EXPECT_LE(largestStep(scene, lookFrom(4.2e5, {0.0, -4e5, -2.3e6}, 0.5)), 3) << "rim from a station";
    EXPECT_LE(largestStep(scene, lookFrom(4.2e5, {1e4, 0.0, -1e4}, 0.9)), 3) << "straight down";
    EXPECT_LE(largestStep(scene, lookFrom(6e7, {0.0, -kGround, 0.0}, 0.25)), 8)
        << "whole planet, along its night";
}

/// As flat as Saturn, whose own sky shows its Sun beside the axis.
TEST_F(AirTest, HazeIsBrightestAroundTheSunOfAFlatPlanetToo) {
    scene::Scene scene = airScene();
    scene.air->flattening = 0.1;
    scene.air->hazeAhead = 0.9;
    const double added = 1.0 / 0.9 - 1.0;
    const double stretched =
        glm::length(glm::dvec3(0.0, 1.0, 0.0) + added * scene.air->axis.y * scene.air->axis);
    scene.air->centre = {0.0, -2.0 - kGround / stretched, 0.0};
    for (const double angle : {0.1, 0.3}) {
        const glm::dvec3 across = glm::normalize(glm::dvec3(0.0, 0.643, 0.766));
        scene.air->toSun = std::cos(angle) * scene.air->axis + std::sin(angle) * across;
        EXPECT_LE(largestStep(scene, lookFrom(0.0, 1e4 * scene.air->axis, 0.9)), 3) << angle;
    }
}

/// Near and far, opaque and blended, from 2 m and from a station.
TEST_F(AirTest, SurfacesAreVeiledAsInFloat64) {
    scene::Scene scene = airScene();
    scene.materials.push_back({.name = "glass",
                               .baseColorFactor = glm::vec4(0.9f, 0.3f, 0.2f, 0.5f),
                               .alphaMode = scene::AlphaMode::blend});
    addBox(scene, {-30.0, 0.0, -100.0}, glm::mat3(50.0f));
    addBox(scene, {1e4, 8e3, -3e4}, glm::mat3(1.4e4f));
    scene::addInstance(scene, 0, 1, 7, {2.0, 4.0, -30.0}, glm::mat3(9.0f));
    scene::addInstance(scene, 0, 1, 8, {-5e3, 4e3, -2e4}, glm::mat3(5e3f));
    EXPECT_LE(largestStep(scene, lookFrom(0.0, {0.0, 1e3, -1e4}, 0.9)), 3);
    EXPECT_LE(largestStep(scene, lookFrom(4.2e5, {0.0, 0.0, -3e4}, 0.1)), 3);
}

/// Its background is lit by the shader, too, though a stencil marks surfaces.
TEST_F(AirTest, AVisibilityBufferShowsTheSame) {
    scene::Scene scene = airScene();
    addBox(scene, {1e4, 8e3, -3e4}, glm::mat3(1.4e4f));
    EXPECT_LE(largestStep(scene, lookFrom(0.0, {0.0, 1e3, -1e4}, 0.9), render::SurfacePath::visibility), 3);
}

/// At dusk light comes a long way. What stands for the sum over it is off by a third at most, of what is dark.
TEST_F(AirTest, DuskIsNearFloat64AndNightIsDark) {
    scene::Scene scene = airScene();
    const scene::Camera camera = lookFrom(0.0, {-5e4, 2e4, -5e4}, 0.8);
    scene.air->toSun = glm::normalize(glm::dvec3(-1.0, 0.03, -1.0));
    EXPECT_LE(largestStep(scene, camera), 8);
    scene.air->toSun = glm::normalize(glm::dvec3(-1.0, -1.0, -1.0));
    const render::Frame night = draw(scene, camera, smallOptions(depth::parseTechnique("anchored")));
    for (const image::Rgba8& pixel : night.color.pixels) {
        ASSERT_LE(std::max({pixel[0], pixel[1], pixel[2]}), 1);
    }
}

TEST_F(AirTest, AirThatScattersNothingChangesNoBit) {
    scene::Scene scene = airScene();
    addBox(scene, {1e4, 8e3, -3e4}, glm::mat3(1.4e4f));
    scene.background = {0.3f, 0.2f, 0.1f};
    const scene::Camera camera = lookFrom(0.0, {0.0, 1e3, -1e4}, 0.9);
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    options.effects.finish.toneMap = render::ToneMap::none;
    scene.air->molecules.scattering = glm::vec3(0.0f);
    scene.air->haze.scattering = glm::vec3(0.0f);
    const std::string still = hashOf(draw(scene, camera, options));
    scene.air->molecules.scattering.b = 1e-4f;
    EXPECT_NE(hashOf(draw(scene, camera, options)), still);
    scene.air.reset();
    EXPECT_EQ(hashOf(draw(scene, camera, options)), still);
}

TEST_F(AirTest, HighlightsAreCompressedUnlessTold) {
    const scene::Scene scene = airScene();
    const scene::Camera camera = lookFrom(0.0, {0.0, 1e3, -1e4}, 0.9);
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    const auto hashWith = [&](render::ToneMap toneMap) {
        options.effects.finish.toneMap = toneMap;
        return hashOf(draw(scene, camera, options));
    };
    EXPECT_EQ(hashWith(render::ToneMap::scene), hashWith(render::ToneMap::neutral));
    EXPECT_NE(hashWith(render::ToneMap::scene), hashWith(render::ToneMap::none));
}

TEST_F(AirTest, ALensWithAFocusRefusesIt) {
    scene::Scene scene = airScene();
    addBox(scene, {0.0, 0.0, -100.0}, glm::mat3(50.0f));
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    options.targets = render::TargetsKind::layers;
    options.focus = {.distance = 100.0, .aperture = 0.5};
    EXPECT_THROW(draw(scene, lookFrom(0.0, {0.0, 0.0, -1.0}, 0.9), options), base::InputError);
}

/// As far as float64 goes there is none. Under the ground it is as thick as on it, and at the centre a picture is drawn, too.
TEST_F(AirTest, AnyPlaceHasAPicture) {
    scene::Scene scene = airScene();
    EXPECT_LE(largestStep(scene, lookFrom(-300.0, {3e3, 6e3, -1e4}, 0.5)), 3);
    scene.background = glm::vec3(1.0f);
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    options.effects.finish.toneMap = render::ToneMap::none;
    const auto seenFrom = [&](const glm::dvec3& eye) {
        const glm::dvec3 forward = glm::normalize(glm::dvec3(1.0, 0.5, 0.0));
        return draw(scene, scene::lookAlong({.fovY = 1.0}, eye, forward), options).color.at(240, 135);
    };
    EXPECT_EQ(seenFrom({0.0, 1e30, 0.0}), (image::Rgba8{255, 255, 255, 255}));
    EXPECT_EQ(seenFrom(scene.air->centre), (image::Rgba8{0, 0, 0, 255}));
}

/// Those that float32 has no number for, or that it cannot square. A driver may show what is no number as the brightest light.
TEST_F(AirTest, AnyHeightOfTheAirHasAPicture) {
    scene::Scene scene = airScene();
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"), 16, 9);
    options.linear = true;
    for (const double height : {1e-300, 1e-40, 1e30, 1e300}) {
        scene.air->molecules.height = height;
        for (const double target : {-1e4, 1e4}) {
            const render::Frame frame = draw(scene, lookFrom(1e3, {0.0, target, -1e4}, 1.0), options);
            ASSERT_FALSE(frame.linear.pixels.empty());
            for (const glm::vec3& light : frame.linear.pixels) {
                ASSERT_LT(light.r + light.g + light.b, 12.0f) << height << " " << target;
            }
        }
    }
}

} // namespace

} // namespace cdr::render_test
