#include "../fixture.h"
#include "../steps.h"

#include <cdr/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cdr::render_test {

namespace {

using render::Frame;
using render::RenderOptions;

constexpr std::uint32_t kFloor = 0;
constexpr double kRadius = 1.0;

/// A floor at y = -1, a wall across it 8 units behind the camera's target, and a box that stands on the floor.
/// So it has corners at many distances. It is lit by ambient light alone. So a pixel's brightness shows how open
/// its surface is.
scene::Scene cornerScene() {
    scene::Scene scene = boxScene();
    scene.lights.clear();
    scene.ambient = glm::vec3(0.5f);
    const auto stretched = [](float x, float y, float z) {
        return glm::mat3(x, 0.0f, 0.0f, 0.0f, y, 0.0f, 0.0f, 0.0f, z);
    };
    addBox(scene, glm::dvec3(0.0, -1.5, -8.0), stretched(20.0f, 1.0f, 16.0f));
    addBox(scene, glm::dvec3(0.0, 2.0, -14.5), stretched(20.0f, 6.0f, 1.0f));
    addBox(scene, glm::dvec3(0.5, -0.5, -7.0));
    return scene;
}

/// Looks down at the corners.
const scene::Camera kEffectsCamera = scene::lookAt({.fovY = 0.7, .nearView = 0.5, .farView = 100.0},
                                                   glm::dvec3(0.0, 5.0, 2.0), glm::dvec3(0.0, -1.0, -12.0));

/// A boundary on the floor right before the wall: what darkens it is in the other cascade.
const std::string kCornerCut = fmt::format("at:{}", kEffectsCamera.viewDistance({0.0, -1.0, -13.9}));

RenderOptions occluded(const depth::Technique& technique, bool perLayer = false) {
    RenderOptions options = smallOptions(technique);
    options.effects.occlusion = {.radius = kRadius, .perLayer = perLayer};
    if (perLayer) {
        options.targets = render::TargetsKind::accumulate;
    }
    return options;
}

/// Pixels of which a channel differs by more than `most`.
std::size_t differing(const image::ImageRgba8& a, const image::ImageRgba8& b, int most) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        count += largestStep(a.pixels[i], b.pixels[i]) > most ? 1 : 0;
    }
    return count;
}

depth::Technique technique(depth::Mapping mapping, const char* split) {
    return depth::Technique{mapping, depth::parseSplit(split), depth::DepthFormat::d32f};
}

class EffectsTest : public RenderTest {};

TEST_F(EffectsTest, OcclusionDarkensCornersAndLeavesOpenFloorAlone) {
    const scene::Scene scene = cornerScene();
    const Frame open = draw(scene, kEffectsCamera, smallOptions(depth::parseTechnique("reversed")));
    const Frame frame = draw(scene, kEffectsCamera, occluded(depth::parseTechnique("reversed")));
    std::size_t corners = 0;
    std::size_t flat = 0;
    for (std::uint32_t y = 4; y + 4 < frame.height();
         ++y) { // away from the rim, where half of what darkens is unseen
        for (std::uint32_t x = 48; x + 48 < frame.width(); ++x) {
            const auto pick = frame.pick(x, y);
            if (!pick || pick->object != kFloor || pick->normal.y < 0.9) {
                continue;
            }
            const double toWall = pick->position.z + 14.0;
            const glm::dvec3 fromBox = glm::abs(pick->position - glm::dvec3(0.5, -1.0, -7.0));
            const double toBox = glm::length(glm::max(fromBox - glm::dvec3(0.5, 0.0, 0.5), glm::dvec3(0.0)));
            const int before = open.color.at(x, y)[0];
            const int after = frame.color.at(x, y)[0];
            if (toWall < 0.2 && toBox > 2.0) {
                ++corners;
                EXPECT_LT(after, before - 12) << x << " " << y;
            } else if (toWall > 1.5 && toBox > 1.5 && pick->distanceView < 14.0) {
                ++flat;
                EXPECT_NEAR(after, before, 1) << x << " " << y;
            }
        }
    }
    EXPECT_GT(corners, 100u);
    EXPECT_GT(flat, 5'000u);
}

/// The shader has the radius as a float, and this one rounds to 0.
TEST_F(EffectsTest, TheLeastRadiusOfOcclusionDarkensNothing) {
    const scene::Scene scene = cornerScene();
    RenderOptions options = quarterOf(smallOptions(depth::parseTechnique("reversed")));
    const Frame open = draw(scene, kEffectsCamera, options);
    for (const bool perLayer : {false, true}) {
        options = quarterOf(occluded(depth::parseTechnique("reversed"), perLayer));
        options.effects.occlusion.radius = 1e-50;
        EXPECT_EQ(draw(scene, kEffectsCamera, options).color, open.color) << perLayer;
    }
}

TEST_F(EffectsTest, OcclusionAndFogAreTheSameWhateverTheTechnique) {
    const scene::Scene scene = cornerScene();
    RenderOptions options = occluded(depth::parseTechnique("reversed"));
    options.effects.fog.visibility = 300.0;
    const Frame first = draw(scene, kEffectsCamera, options);
    for (const depth::Mapping mapping : depth::kMappings) {
        for (const std::string& split : {std::string("none"), std::string("count:6"), kCornerCut}) {
            options.technique = technique(mapping, split.c_str());
            const Frame frame = draw(scene, kEffectsCamera, options);
            EXPECT_LT(differing(frame.color, first.color, 2), first.color.pixels.size() / 1000)
                << nameOf(options.technique);
        }
    }
}

/// Anchors of four cascades reach full-screen passes as flat varyings, those of more in a buffer.
TEST_F(EffectsTest, AFifthCascadeOverNothingChangesNoBit) {
    scene::Scene scene = cornerScene();
    scene.lights.push_back({.position = glm::dvec3(1.0, 3.0, -6.0), .halfDistance = 5.0});
    const Frame four =
        draw(scene, kEffectsCamera, occluded(technique(depth::Mapping::anchored, "at:9,12,15")));
    const Frame five =
        draw(scene, kEffectsCamera, occluded(technique(depth::Mapping::anchored, "at:9,12,15,60")));
    ASSERT_EQ(four.cascades.size(), 4u);
    ASSERT_EQ(five.cascades.size(), 5u);
    std::array<std::size_t, 4> pixels{};
    for (std::uint32_t x = 0; x < four.width(); ++x) {
        for (std::uint32_t y = 0; y < four.height(); ++y) {
            ++pixels.at(four.cascade(x, y));
        }
    }
    EXPECT_GT(*std::min_element(pixels.begin(), pixels.end()), 1'000u);
    EXPECT_EQ(hashOf(four), hashOf(five));
}

TEST_F(EffectsTest, PerLayerLosesWhatOtherCascadesHold) {
    const scene::Scene scene = cornerScene();
    const depth::Technique oneCascade = technique(depth::Mapping::reversed, "none");
    EXPECT_LT(differing(draw(scene, kEffectsCamera, occluded(oneCascade, true)).color,
                        draw(scene, kEffectsCamera, occluded(oneCascade)).color, 2),
              100u);
    const depth::Technique cut = technique(depth::Mapping::reversed, kCornerCut.c_str());
    const Frame whole = draw(scene, kEffectsCamera, occluded(cut));
    const Frame layers = draw(scene, kEffectsCamera, occluded(cut, true));
    EXPECT_GT(differing(layers.color, whole.color, 8), 1'000u);
}

TEST_F(EffectsTest, PerLayerIsTheSameOverTargets) {
    const scene::Scene scene = cornerScene();
    RenderOptions options = occluded(technique(depth::Mapping::anchored, "count:5"), true);
    const std::string first = hashOf(draw(scene, kEffectsCamera, options));
    for (const render::TargetsChoice choice :
         {render::TargetsChoice::pool(2), render::TargetsChoice(render::TargetsKind::layers)}) {
        options.targets = choice;
        options.threads = 2;
        EXPECT_EQ(hashOf(draw(scene, kEffectsCamera, options)), first) << nameOf(choice);
    }
}

/// Also a million units away, where anchored depth keeps distances.
TEST_F(EffectsTest, FogTakesWhatItsVisibilitySays) {
    for (const double distance : {10.0, 1e6}) {
        scene::Scene scene = boxScene();
        scene.materials[0].unlit = true;
        const auto side = static_cast<float>(0.5 * distance);
        addBox(scene, glm::dvec3(0.0, 0.0, -1.25 * distance), glm::mat3(side));
        RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.effects.fog = {.visibility = 2.0 * distance, .color = glm::vec3(0.0f, 0.25f, 0.5f)};
        const Frame frame = draw(scene, {.fovY = 0.5, .nearView = 0.1, .farView = 1e8}, options);
        const double across = std::tan(0.25) / 135.0;
        for (const std::uint32_t x : {240u, 340u}) {
            const double ray = std::hypot(1.0, (x + 0.5 - 240.0) * across);
            const double left = std::pow(0.02, distance * ray / (2.0 * distance));
            const double blue = left + 0.5 * (1.0 - left);
            const double encoded = 255.0 * (1.055 * std::pow(blue, 1.0 / 2.4) - 0.055);
            EXPECT_NEAR(frame.color.at(x, 135)[2], encoded, 1.0) << distance;
        }
        EXPECT_NEAR(frame.color.at(1, 1)[2], 188, 1); // the background is fog alone
    }
}

TEST_F(EffectsTest, RefusesWhatCannotBe) {
    const scene::Scene scene = cornerScene();
    RenderOptions options = occluded(depth::parseTechnique("cdr"), true);
    options.targets = render::TargetsKind::onePass;
    EXPECT_THROW(draw(scene, kEffectsCamera, options), base::InputError);
    options.effects = {.fog = {.visibility = std::numeric_limits<double>::infinity()}};
    EXPECT_THROW(draw(scene, kEffectsCamera, options), base::InputError);
    options.effects = {.fog = {.visibility = 1.0, .color = glm::vec3(2.0f)}};
    EXPECT_THROW(draw(scene, kEffectsCamera, options), base::InputError);
}

} // namespace

} // namespace cdr::render_test
