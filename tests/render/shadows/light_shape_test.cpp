#include "../fixture.h"

#include <cdr/render/shadows/light_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace cdr::render_test {

namespace {

using render::DirectionWindow;
using render::LightView;
using scene::LightCone;
using scene::PointLight;

/// Directions, cones and windows of any kind.
class Directions {
  public:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }
    glm::dvec3 direction() {
        std::normal_distribution<double> along;
        return glm::normalize(glm::dvec3(along(m_random), along(m_random), along(m_random)));
    }
    /// From a thousandth of its depth to wider than a side of a light.
    DirectionWindow window(double depth) {
        const double reach = depth * std::exp2(between(-10.0, 1.0));
        const glm::dvec2 low = depth * glm::dvec2(between(-1.0, 1.0), between(-1.0, 1.0));
        return {
            .low = low, .high = low + glm::dvec2(between(0.0, reach), between(0.0, reach)), .depth = depth};
    }

  private:
    std::mt19937_64 m_random{11};
};

constexpr int kSteps = 60;

/// Calls with directions of a window, its edges included.
template <typename Take>
void forDirections(const DirectionWindow& window, const Take& take) {
    for (int y = 0; y <= kSteps; ++y) {
        for (int x = 0; x <= kSteps; ++x) {
            const glm::dvec2 place = glm::mix(window.low, window.high, glm::dvec2(x, y) / double{kSteps});
            take(glm::normalize(glm::dvec3(place, window.depth)));
        }
    }
}

TEST(LightShape, TheGreatestCosineIsThatOfSampledDirections) {
    Directions directions;
    for (const double depth : {1.0, 1e-3, 7e8}) {
        for (int i = 0; i < 300; ++i) {
            const DirectionWindow window = directions.window(depth);
            const glm::dvec3 axis = directions.direction();
            double sampled = -1.0;
            forDirections(window,
                          [&](const glm::dvec3& way) { sampled = std::max(sampled, glm::dot(axis, way)); });
            const double greatest = render::greatestCosine(axis, window);
            EXPECT_GE(greatest, sampled - 1e-14);
            // An angle to the nearest sample of half a step along each side, at most.
            const double step = glm::length(window.high - window.low) / depth / kSteps;
            EXPECT_LE(std::acos(std::clamp(sampled, -1.0, 1.0)),
                      std::acos(std::clamp(greatest, -1.0, 1.0)) + 0.5 * step + 1e-7);
        }
    }
}

TEST(LightShape, AConeThatAWindowHoldsIsFound) {
    const DirectionWindow window{.low = {-0.5, 0.25}, .high = {0.5, 0.75}, .depth = 1.0};
    EXPECT_EQ(render::greatestCosine(glm::normalize(glm::dvec3(0.1, 0.5, 1.0)), window), 1.0);
    EXPECT_LT(render::greatestCosine(glm::normalize(glm::dvec3(0.1, 0.2, 1.0)), window), 1.0);
    EXPECT_NEAR(render::greatestCosine({0.0, 0.0, -1.0}, window), -1.0 / std::sqrt(1.0 + 0.25 + 0.5625),
                1e-15);
}

/// The sides of a light inside a box, which all show something.
class LightSides {
  public:
    explicit LightSides(const PointLight& light) : m_light(light) {}

    std::vector<LightView> views(double lightDistance = 0.0) const {
        PointLight light = m_light;
        light.position += glm::dvec3(lightDistance, 0.0, 0.0);
        return render::lightViews(light, glm::dvec3(0.0), slice(), 1e-3, 512);
    }

  private:
    static render::ReceiverSlice slice() {
        render::ReceiverSlice slice{.nearView = 1.0, .farView = 16.0, .view = {}, .boxes = {}, .reach = 9.0};
        for (std::size_t i = 0; i < 8; ++i) {
            slice.boxes[i] = slice.view[i] = {(i & 1) != 0 ? 5.0 : -5.0, (i & 2) != 0 ? 5.0 : -5.0,
                                              (i & 4) != 0 ? 5.0 : -5.0};
        }
        return slice;
    }
    PointLight m_light;
};

bool isSame(const LightView& a, const LightView& b) {
    return a.ahead == b.ahead && a.low == b.low && a.texel == b.texel && a.size == b.size &&
           a.farAhead == b.farAhead && a.origin == b.origin;
}

TEST(LightShape, AConeKeepsTheSidesThatItTouches) {
    Directions directions;
    std::array<std::size_t, 7> drawn{};
    for (int i = 0; i < 200; ++i) {
        PointLight light{.position = glm::dvec3(directions.between(-4.0, 4.0))};
        for (const double lightDistance : {0.0, 50.0, 1e9}) {
            light.cone.reset();
            const std::vector<LightView> all = LightSides(light).views(lightDistance);
            light.cone = LightCone{.direction = directions.direction(),
                                   .outer = directions.between(0.001, 0.5 * std::numbers::pi)};
            const std::vector<LightView> kept = LightSides(light).views(lightDistance);
            drawn[kept.size()] += lightDistance == 0.0;
            const double edge = std::cos(light.cone->outer);
            for (const LightView& side : all) {
                double greatest = -1.0;
                const glm::dvec2 size(side.size.width, side.size.height);
                forDirections(
                    {.low = side.low, .high = side.low + side.texel * size, .depth = 1.0 / side.wPerUnit},
                    [&](const glm::dvec3& way) {
                        greatest = std::max(greatest, glm::dot(side.toLight(light.cone->direction), way));
                    });
                const bool isKept = std::any_of(kept.begin(), kept.end(),
                                                [&](const LightView& other) { return isSame(side, other); });
                EXPECT_TRUE(isKept || greatest < edge) << i << ", a cone of " << light.cone->outer;
                EXPECT_TRUE(!isKept || greatest > edge - 0.03) << i << ", a cone of " << light.cone->outer;
            }
            EXPECT_LE(kept.size(), all.size());
        }
    }
    EXPECT_EQ(drawn[0], 0u); // the light is inside the box
    EXPECT_GT(drawn[1], 0u);
    EXPECT_GT(drawn[1] + drawn[2] + drawn[3], drawn[4] + drawn[5] + drawn[6]);
}

TEST(LightShape, BeyondItsRangeALightHasNoViews) {
    PointLight light{.position = {25.0, 0.0, 0.0}};
    EXPECT_FALSE(LightSides(light).views().empty());
    light.range = 20.0; // as far as the box
    EXPECT_FALSE(LightSides(light).views().empty());
    light.range = 19.9;
    EXPECT_TRUE(LightSides(light).views().empty());
}

/// A light between boxes in a hall, whose camera looks past it.
class ShapedShadowsTest : public RenderTest {
  protected:
    ShapedShadowsTest() {
        m_options.width = 96;
        m_options.height = 64;
        m_options.shadows = {.method = render::ShadowMethod::anchored, .maxTexels = 256};
        m_scene.ambient = glm::vec3(0.1f);
        for (int side = 0; side < 6; ++side) {
            glm::dvec3 place(0.0);
            place[side / 2] = side % 2 == 0 ? 6.0 : -6.0;
            glm::vec3 sides(12.0f);
            sides[side / 2] = 0.5f;
            addBox(m_scene, place, glm::mat3(sides.x, 0, 0, 0, sides.y, 0, 0, 0, sides.z));
            addBox(m_scene, 0.35 * place, glm::mat3(0.8f));
        }
    }

    /// The picture with the shadows of a light in all directions, whatever its shape: each pixel with that light or without.
    image::ImageRgba8 withAllShadows(const PointLight& light, const scene::Camera& camera) {
        scene::Scene scene = m_scene;
        scene.lights = {light};
        scene.lights.front().cone.reset();
        scene.lights.front().range.reset();
        const image::ImageRgba8 reached = draw(scene, camera, m_options).litMask;
        RenderOptions plain = m_options;
        plain.shadows = {};
        scene.lights = {light};
        image::ImageRgba8 picture = draw(scene, camera, plain).color;
        scene.lights.front().color = glm::vec3(0.0f);
        const image::ImageRgba8 dark = draw(scene, camera, plain).color;
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            picture.pixels[i] = reached.pixels[i][0] != 0 ? picture.pixels[i] : dark.pixels[i];
        }
        return picture;
    }
    render::Frame drawWith(const PointLight& light, const scene::Camera& camera) {
        scene::Scene scene = m_scene;
        scene.lights = {light};
        return draw(scene, camera, m_options);
    }

    using RenderOptions = render::RenderOptions;
    scene::Scene m_scene = boxScene();
    RenderOptions m_options = smallOptions(depth::namedTechnique("anchored").technique);
};

TEST_F(ShapedShadowsTest, PicturesAreThoseOfMapsInAllDirections) {
    const scene::Camera camera =
        scene::lookAt({.fovY = 1.2, .nearView = 0.1, .farView = 100.0}, {4.8, 3.7, 5.0}, glm::dvec3(0.0));
    Directions directions;
    PointLight light{.position = {0.3, -0.2, 0.4}, .color = glm::vec3(1.5f), .halfDistance = 5.0};
    const std::size_t all = drawWith(light, camera).stats.shadows.maps;
    std::size_t maps = 0;
    constexpr int kCones = 24;
    for (int i = 0; i < kCones; ++i) {
        light.cone = LightCone{.direction = directions.direction(), .outer = 0.02 + 1.5 * i / kCones};
        const render::Frame drawn = drawWith(light, camera);
        EXPECT_EQ(drawn.color.pixels, withAllShadows(light, camera).pixels)
            << "a cone of " << light.cone->outer;
        maps += drawn.stats.shadows.maps;
    }
    EXPECT_LT(maps, kCones * all * 2 / 3);
}

} // namespace

} // namespace cdr::render_test
