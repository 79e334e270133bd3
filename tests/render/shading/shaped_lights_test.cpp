#include "../fixture.h"
#include "../steps.h"

#include <cdr/measure/shadows/shadow_truth.h>
#include <cdr/measure/shadows/wrong_shadows.h>
#include <cdr/render/shading/seen_lights.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace cdr::render_test {

namespace {

using scene::LightCone;
using scene::PointLight;

const scene::Camera kLampCamera =
    scene::lookAt({.fovY = 0.8, .nearView = 0.1, .farView = 1000.0}, {0.0, 3.0, 7.0}, glm::dvec3(0.0));

/// Boxes on a slab, matt and shiny, and a pane of glass before them.
scene::Scene room(const glm::dvec3& centre) {
    scene::Scene scene = boxScene();
    scene.ambient = glm::vec3(0.05f);
    scene.lights.clear();
    scene.materials.push_back(
        {.name = "shiny",
         .baseColorFactor = glm::vec4(0.64f, 0.36f, 0.16f, 1.0f),
         .metallicRoughness = scene::MetallicRoughness{.metallic = 0.5f, .roughness = 0.4f}});
    scene.materials.push_back({.name = "glass",
                               .baseColorFactor = glm::vec4(0.3f, 0.5f, 0.9f, 0.4f),
                               .alphaMode = scene::AlphaMode::blend});
    const auto add = [&](std::uint32_t material, const glm::dvec3& position, const glm::vec3& sides) {
        scene::addInstance(scene, 0, material, static_cast<std::uint32_t>(scene.instances.size()),
                           centre + position, glm::mat3(sides.x, 0, 0, 0, sides.y, 0, 0, 0, sides.z));
    };
    add(0, {0.0, -1.0, 0.0}, {9.0f, 0.5f, 9.0f});
    for (std::uint32_t i = 0; i < 4; ++i) {
        add(i % 2, {1.3 * i - 2.0, 0.0, -0.4 * i}, glm::vec3(0.9f));
    }
    add(2, {0.5, 0.5, 2.0}, {2.0f, 1.5f, 0.05f});
    return scene;
}

PointLight spotAt(const glm::dvec3& position, const glm::dvec3& target) {
    return {.position = position,
            .color = glm::vec3(1.2f, 1.0f, 0.7f),
            .halfDistance = 6.0,
            .cone = LightCone{.direction = glm::normalize(target - position), .inner = 0.15, .outer = 0.42}};
}

/// A spot, a point light with a range, and both in one.
void addShapedLights(scene::Scene& scene, const glm::dvec3& centre) {
    scene.lights.push_back(spotAt(centre + glm::dvec3(-2.0, 4.0, 3.0), centre));
    scene.lights.push_back({.position = centre + glm::dvec3(2.5, 1.0, 1.5),
                            .color = glm::vec3(0.3f, 0.5f, 1.0f),
                            .halfDistance = 2.0,
                            .range = 3.5});
    scene.lights.push_back(spotAt(centre + glm::dvec3(3.0, 5.0, -1.0), centre + glm::dvec3(1.5, 0.0, 0.0)));
    scene.lights.back().range = 6.5;
}

class ShapedLightsTest : public RenderTest {
  protected:
    static render::RenderOptions options(const char* technique) {
        return withSorting(smallOptions(depth::parseTechnique(technique), 320, 180));
    }

    OffTruth offTruthOf(const scene::Scene& scene, const scene::Camera& camera, const char* technique) {
        const image::ImageRgba8 picture = draw(scene, camera, options(technique)).color;
        return offTruth(layersOf(scene, camera, picture.width, picture.height), picture);
    }
};

TEST_F(ShapedLightsTest, LookAsFloat64Truth) {
    scene::Scene scene = room(glm::dvec3(0.0));
    addShapedLights(scene, glm::dvec3(0.0));
    for (const char* technique : {"standard", "anchored", "cdr", "log"}) {
        const auto [off, inner] = offTruthOf(scene, kLampCamera, technique);
        EXPECT_GT(inner, 30'000u);
        EXPECT_LT(off * 200, inner) << technique;
    }
    // Each is seen: without one of its shapes, or without itself, the picture is another.
    const render::Frame whole = draw(scene, kLampCamera, options("anchored"));
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        for (const bool isCone : {true, false}) {
            scene::Scene other = scene;
            const bool had = isCone ? other.lights[i].cone.has_value() : other.lights[i].range.has_value();
            isCone ? other.lights[i].cone.reset() : other.lights[i].range.reset();
            const render::Frame frame = draw(other, kLampCamera, options("anchored"));
            EXPECT_EQ(frame.color == whole.color, !had) << i << isCone;
        }
    }
}

TEST_F(ShapedLightsTest, AMillionUnitsAwayToo) {
    const glm::dvec3 centre(123'456.75, -7'654.5, 9'876.25);
    scene::Scene scene = room(centre);
    addShapedLights(scene, centre);
    const scene::Camera camera{
        .position = centre + glm::dvec3(0.0, 0.0, 1e6), .fovY = 5e-6, .nearView = 0.001, .farView = 2e6};
    const auto [off, inner] = offTruthOf(scene, camera, "anchored");
    EXPECT_GT(inner, 20'000u);
    EXPECT_LT(off * 200, inner);
}

TEST_F(ShapedLightsTest, NothingIsLitBeyondTheRangeOrTheCone) {
    scene::Scene dark = room(glm::dvec3(0.0));
    const std::string wanted = hashOf(draw(dark, kLampCamera, options("anchored")));
    scene::Scene scene = dark;
    scene.lights = {{.position = {0.0, 10.0, 0.0}, .halfDistance = 50.0, .range = 5.0}};
    EXPECT_EQ(hashOf(draw(scene, kLampCamera, options("anchored"))), wanted);
    scene.lights = {spotAt({0.0, 10.0, 0.0}, {0.0, 20.0, 0.0})};
    EXPECT_EQ(hashOf(draw(scene, kLampCamera, options("anchored"))), wanted);
    scene.lights = {spotAt({0.0, 10.0, 0.0}, {0.0, 0.0, 0.0})};
    EXPECT_NE(hashOf(draw(scene, kLampCamera, options("anchored"))), wanted);
}

/// Shaped lights are read in another way than others. A range that nothing comes near to changes no bit.
TEST_F(ShapedLightsTest, AnEndlessRangeIsNoneToTheBit) {
    for (const std::size_t count : {1u, 4u, 7u}) {
        scene::Scene scene = room(glm::dvec3(0.0));
        for (std::size_t i = 0; i < count; ++i) {
            const auto at = static_cast<double>(i);
            scene.lights.push_back({.position = {2.0 * at - 4.0, 4.0, 1.0 + at}, .halfDistance = 2.0});
        }
        scene::Scene ranged = scene;
        ranged.lights.back().range = 1e30;
        render::RenderOptions chosen = options("anchored");
        EXPECT_EQ(hashOf(draw(scene, kLampCamera, chosen)), hashOf(draw(ranged, kLampCamera, chosen)))
            << count;
        if (count == 4) {
            chosen.shadows.method = render::ShadowMethod::anchored;
            EXPECT_EQ(hashOf(draw(scene, kLampCamera, chosen)), hashOf(draw(ranged, kLampCamera, chosen)));
        }
    }
}

TEST_F(ShapedLightsTest, TheBitsAreTheSameForTargetsThreadsAndSubmissions) {
    scene::Scene scene = room(glm::dvec3(0.0));
    addShapedLights(scene, glm::dvec3(0.0));
    expectOnePicture(scene, kLampCamera, options("cdr"));
}

TEST_F(ShapedLightsTest, VisibilityBuffersShowTheSame) {
    scene::Scene scene = room(glm::dvec3(0.0));
    addShapedLights(scene, glm::dvec3(0.0));
    scene.materials[2].alphaMode = scene::AlphaMode::opaque; // blended surfaces read the G-buffer
    render::RenderOptions chosen = options("anchored");
    const render::Frame direct = draw(scene, kLampCamera, chosen);
    chosen.surface = render::SurfacePath::visibility;
    const render::Frame resolved = draw(scene, kLampCamera, chosen);
    std::size_t off = 0;
    for (std::size_t i = 0; i < direct.color.pixels.size(); ++i) {
        off += std::abs(int{direct.color.pixels[i][0]} - int{resolved.color.pixels[i][0]}) > 2 ? 1 : 0;
    }
    EXPECT_LT(off, 60u); // edges
}

/// Lights whose range ends before the view. Where a light stands first in the scene it is never left out.
TEST_F(ShapedLightsTest, ThoseOutOfSightAreLeftOutAndNoBitChanges) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> around(-9.0, 9.0);
    std::uniform_real_distribution<double> exponent(0.0, 4.0);
    std::size_t leftOut = 0;
    std::size_t shining = 0;
    for (const double far : {0.0, 1e6}) {
        const glm::dvec3 centre(far, 0.0, -far);
        scene::Camera camera = kLampCamera;
        camera.position += centre;
        render::RenderOptions drawn = options("anchored");
        drawn.width = 96;
        drawn.height = 54;
        scene::Scene scene = room(centre);
        const render::Frame dark = draw(scene, camera, drawn);
        for (int i = 0; i < 40; ++i) {
            PointLight light{.position = centre + glm::dvec3(around(random), around(random), around(random)),
                             .halfDistance = 4.0,
                             .range = std::exp2(exponent(random))};
            const PointLight black{.position = centre, .color = glm::vec3(0.0f)};
            scene.lights = {light, black, black, black, black};
            const render::Frame first = draw(scene, camera, drawn);
            std::reverse(scene.lights.begin(), scene.lights.end());
            const render::Frame last = draw(scene, camera, drawn);
            EXPECT_EQ(first.color, last.color) << "light " << i << ", " << far << " units away";
            const auto seen = render::seenLights(scene.lights, camera, scene::frustumOf(camera, 96, 54));
            leftOut += seen.size() == 4 ? 1 : 0;
            shining += first.color != dark.color ? 1 : 0;
        }
    }
    EXPECT_GT(leftOut, 10u);
    EXPECT_GT(shining, 10u);
}

} // namespace

} // namespace cdr::render_test
