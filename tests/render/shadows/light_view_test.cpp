#include <cdr/render/shadows/cull_casters.h>
#include <cdr/render/shadows/divided_view.h>
#include <cdr/render/shadows/light_view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace cdr::render_test {

namespace {

using render::LightView;
using render::ReceiverSlice;

constexpr std::uint32_t kTexels = 1024;

/// Whether it is a power of two, or 1.5 times one.
bool isTexelStep(double texel) {
    int exponent = 0;
    const double mantissa = std::frexp(texel, &exponent);
    return mantissa == 0.5 || mantissa == 0.75;
}

/// A crowd of small spheres in front of a camera that stands far from the world's origin.
class LightViewTest : public testing::Test {
  protected:
    LightViewTest() {
        m_camera.position = glm::dvec3(3e6, -2e6, 1e6);
        m_camera.nearView = 0.1;
        m_camera.farView = 1e5;
        m_scene.materials.push_back({.name = "white"});
        m_scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    }

    void add(const glm::dvec3& fromCamera, float side) {
        scene::addInstance(m_scene, 0, 0, static_cast<std::uint32_t>(m_scene.instances.size()),
                           m_camera.position + fromCamera, glm::mat3(side));
    }
    void addCrowd(std::size_t count) {
        std::uniform_real_distribution<double> across(-20.0, 20.0);
        std::uniform_real_distribution<double> ahead(5.0, 60.0);
        for (std::size_t i = 0; i < count; ++i) {
            add({across(m_random), across(m_random), -ahead(m_random)}, 0.25f);
        }
    }
    scene::Frustum frustum() const { return scene::frustumOf(m_camera, 1280, 720); }
    std::vector<ReceiverSlice> slices() {
        m_cells.build(m_scene, m_workers);
        visibility::cullCells(m_cells, m_camera, frustum(), m_workers, m_visible);
        return render::receiverSlices(m_camera, frustum(), render::seenSpheres(m_camera, m_visible));
    }
    std::vector<LightView> viewsOf(const glm::dvec3& lightFromCamera, const ReceiverSlice& slice) const {
        return render::lightViews({.position = m_camera.position + lightFromCamera}, m_camera.position, slice,
                                  frustum().footprintSlope, kTexels);
    }
    /// Texels of the map and normalised depth, as the device works them out but in float64.
    glm::dvec3 inMap(const LightView& view, const glm::dvec3& fromCamera) const {
        const glm::dvec3 place = view.toLight((m_camera.position - view.origin) + fromCamera);
        const shaders::LightLens lens = view.lens();
        const double w = view.w(place.z);
        const double z =
            (static_cast<double>(lens.zOffset) + static_cast<double>(lens.zPerUnit) * place.z) / w;
        return {(glm::dvec2(place) / w - view.low) / view.texel, z};
    }
    bool shows(const LightView& view, const glm::dvec3& fromCamera) const {
        const glm::dvec3 place = view.toLight((m_camera.position - view.origin) + fromCamera);
        const glm::dvec3 map = inMap(view, fromCamera);
        return view.w(place.z) > 0.0 && map.x >= 0.0 && map.y >= 0.0 && map.x <= view.size.width &&
               map.y <= view.size.height;
    }

    /// What a camera would see of the view if its texels were so many pixels wide.
    std::vector<LightView> dividedAt(double pixels, const LightView& view, const ReceiverSlice& slice) const {
        return render::dividedView(view, slice, m_camera.position,
                                   render::pixelsPerTexel(view, 1.0) / pixels);
    }
    bool isSeen(const glm::dvec3& fromCamera, const ReceiverSlice& slice) const {
        const double distanceView = -fromCamera.z;
        return std::abs(fromCamera.x) < frustum().tanX * distanceView &&
               std::abs(fromCamera.y) < frustum().tanY * distanceView && distanceView >= slice.nearView &&
               distanceView < slice.farView;
    }

    /// Centres of instances, relative to the camera.
    std::vector<glm::dvec3> seenIn(const ReceiverSlice& slice) const {
        std::vector<glm::dvec3> seen;
        for (std::size_t i = 0; i < m_scene.instances.size(); ++i) {
            const glm::dvec3 centre = m_scene.instances.position(i) - m_camera.position;
            if (isSeen(centre, slice)) {
                seen.push_back(centre);
            }
        }
        return seen;
    }
    /// Whether a small instance casts a shadow there.
    bool isCaster(const LightView& view, const ReceiverSlice& slice, const glm::dvec3& fromOrigin) {
        scene::Scene scene = m_scene;
        const auto instance = static_cast<std::uint32_t>(scene.instances.size());
        scene::addInstance(scene, 0, 0, instance, view.origin + fromOrigin, glm::mat3(0.01f));
        visibility::InstanceCells cells;
        cells.build(scene, m_workers);
        std::vector<std::uint32_t> casters;
        const render::ReceiverCells receivers(view, slice, m_camera.position);
        render::cullCasters(cells, view, render::CasterTest(view, receivers), casters);
        return std::count(casters.begin(), casters.end(), instance) == 1;
    }

    scene::Camera m_camera;
    scene::Scene m_scene;
    platform::WorkerPool m_workers{2};
    visibility::InstanceCells m_cells;
    visibility::VisibleCells m_visible;
    std::mt19937_64 m_random{7};
};

TEST_F(LightViewTest, SlicesEndAtPowersOfTwoAndHoldWhatIsSeen) {
    add({0.0, 0.0, -10.0}, 1.0f);
    add({0.0, 0.0, -1000.0}, 1.0f);
    add({0.0, 1e4, -10.0}, 1.0f); // not seen
    const std::vector<ReceiverSlice> made = slices();
    ASSERT_EQ(made.size(), 2u); // and none in between
    EXPECT_EQ(made[0].nearView, 8.0);
    EXPECT_EQ(made[0].farView, 16.0);
    EXPECT_EQ(made[1].nearView, 512.0);
    EXPECT_EQ(made[1].farView, 1024.0);
    EXPECT_NEAR(made[0].middle.z, -10.0, 1.0);
    EXPECT_LT(made[0].reach, 3.0);
}

TEST_F(LightViewTest, EachReceiverIsInAMapWhereverTheLightIs) {
    addCrowd(300);
    const std::vector<ReceiverSlice> made = slices();
    std::size_t receivers = 0;
    std::size_t sides = 0;
    for (const glm::dvec3& light : {glm::dvec3(1e9, 2e9, -1e9), glm::dvec3(100.0, 80.0, -30.0),
                                    glm::dvec3(2.0, 1.0, -20.0), glm::dvec3(0.0, 0.0, 0.0)}) {
        for (const ReceiverSlice& slice : made) {
            std::vector<LightView> views = viewsOf(light, slice);
            for (LightView& view : views) {
                std::vector<std::uint32_t> casters;
                const render::ReceiverCells receivers(view, slice, m_camera.position);
                view.nearAhead =
                    render::cullCasters(m_cells, view, render::CasterTest(view, receivers), casters);
                EXPECT_LE(view.size.width, kTexels);
                EXPECT_LE(view.size.height, kTexels);
                EXPECT_LT(view.nearAhead, view.farAhead);
                sides += !view.isDistant();
            }
            for (const glm::dvec3& centre : seenIn(slice)) {
                const auto view = std::find_if(views.begin(), views.end(),
                                               [&](const LightView& some) { return shows(some, centre); });
                ASSERT_NE(view, views.end());
                const double z = inMap(*view, centre).z;
                EXPECT_GE(z, 0.0);
                EXPECT_LE(z, 1.0);
                ++receivers;
            }
        }
    }
    EXPECT_GT(receivers, 400u);
    EXPECT_GT(sides, 6u);
}

TEST_F(LightViewTest, TexelsKeepTheirPlacesAsTheCameraMoves) {
    add({0.0, 0.0, -11.0}, 2.0f);
    const glm::dvec3 light(4e8, 7e8, 2e8);
    const LightView before = viewsOf(light, slices().front()).front();
    const glm::dvec3 step(0.0123, 0.0077, 0.0);
    m_camera.position += step;
    const LightView after = viewsOf(light - step, slices().front()).front();
    ASSERT_EQ(before.texel, after.texel);
    const auto texels = [](const LightView& view) {
        return (view.low + glm::dvec2(glm::dot(view.right, view.origin), glm::dot(view.up, view.origin))) /
               view.texel;
    };
    for (const LightView* view : {&before, &after}) {
        const glm::dvec2 place = texels(*view);
        EXPECT_NEAR(place.x, std::round(place.x), 1e-3);
        EXPECT_NEAR(place.y, std::round(place.y), 1e-3);
    }
    EXPECT_TRUE(isTexelStep(before.texel)) << before.texel;
}

/// Else the edges of shadows would be coarser than the memory of the maps allows.
TEST_F(LightViewTest, WideMapsUseTwoThirdsOfTheirSide) {
    addCrowd(300);
    std::size_t wide = 0;
    for (const glm::dvec3& light : {glm::dvec3(1e9, 2e9, -1e9), glm::dvec3(2.0, 1.0, -20.0)}) {
        for (const ReceiverSlice& slice : slices()) {
            for (const LightView& view : viewsOf(light, slice)) {
                EXPECT_TRUE(isTexelStep(view.texel)) << view.texel;
                // Below, none finer is asked for; above, it is divided instead.
                const double pixels = render::pixelsPerTexel(view, frustum().footprintSlope);
                if (pixels > 0.25 && pixels <= render::kWidestTexel) {
                    EXPECT_GE(3 * std::max(view.size.width, view.size.height), 2 * kTexels - 64);
                    ++wide;
                }
            }
        }
    }
    EXPECT_GT(wide, 3u);
}

TEST_F(LightViewTest, PartsOfAWideMapDecideAboutEachReceiver) {
    addCrowd(300);
    const std::vector<ReceiverSlice> made = slices();
    std::size_t receivers = 0;
    for (const glm::dvec3& light :
         {glm::dvec3(1e9, 2e9, -1e9), glm::dvec3(100.0, 80.0, -30.0), glm::dvec3(2.0, 1.0, -20.0)}) {
        for (const ReceiverSlice& slice : made) {
            for (const LightView& view : viewsOf(light, slice)) {
                const std::vector<LightView> parts = dividedAt(6.0, view, slice);
                ASSERT_LE(parts.size(), 4u);
                for (const LightView& part : parts) {
                    EXPECT_TRUE(part.isPart);
                    EXPECT_EQ(part.texel, 0.5 * view.texel);
                    EXPECT_LE(part.size.width, view.size.width);
                    EXPECT_LE(part.size.height, view.size.height);
                    const glm::dvec2 moved = (part.low - view.low) / part.texel;
                    EXPECT_NEAR(moved.x, std::round(moved.x), 1e-6); // texels keep their places
                    EXPECT_NEAR(moved.y, std::round(moved.y), 1e-6);
                }
                for (std::size_t i = 0; i < m_scene.instances.size(); ++i) {
                    const glm::dvec3 centre = m_scene.instances.position(i) - m_camera.position;
                    if (!isSeen(centre, slice) || !shows(view, centre)) {
                        continue;
                    }
                    EXPECT_TRUE(std::any_of(parts.begin(), parts.end(), [&](const LightView& part) {
                        const glm::dvec3 map = inMap(part, centre);
                        return map.x >= 1.0 && map.y >= 1.0 && map.x <= part.size.width - 1.0 &&
                               map.y <= part.size.height - 1.0;
                    })) << i;
                    ++receivers;
                }
            }
        }
    }
    EXPECT_GT(receivers, 300u);
}

/// A long lens sees a strip of what its map shows.
TEST_F(LightViewTest, PartsBesideWhatIsSeenAreLeftOut) {
    m_camera.fovY = 0.002;
    add({0.0, 0.0, -40.0}, 5.0f);
    const ReceiverSlice slice = slices().front();
    const LightView view = viewsOf({1e9, 2e9, -1e9}, slice).front();
    EXPECT_LT(dividedAt(6.0, view, slice).size(), 4u);
}

TEST_F(LightViewTest, MapsAreDividedOnlyWhereThatSuffices) {
    addCrowd(300);
    const ReceiverSlice slice = slices().front();
    const LightView view = viewsOf({1e9, 2e9, -1e9}, slice).front();
    for (const double pixels : {0.1, 3.9, 8.1, 300.0}) {
        const std::vector<LightView> same = dividedAt(pixels, view, slice);
        ASSERT_EQ(same.size(), 1u) << pixels;
        EXPECT_FALSE(same.front().isPart);
        EXPECT_EQ(same.front().texel, view.texel);
    }
    EXPECT_TRUE(dividedAt(4.1, view, slice).front().isPart);
    EXPECT_TRUE(dividedAt(7.9, view, slice).front().isPart);
}

TEST_F(LightViewTest, CastersAreAllThatMayStandBetween) {
    addCrowd(100);
    const std::vector<ReceiverSlice> made = slices();
    std::size_t tried = 0;
    for (const glm::dvec3& light :
         {glm::dvec3(1e5, 2e5, -1e5), glm::dvec3(60.0, 80.0, -30.0), glm::dvec3(2.0, 1.0, -20.0)}) {
        for (const ReceiverSlice& slice : made) {
            for (const LightView& view : viewsOf(light, slice)) {
                for (const glm::dvec3& receiver : seenIn(slice)) {
                    if (!shows(view, receiver)) {
                        continue;
                    }
                    const glm::dvec3 lit = view.toLight((m_camera.position - view.origin) + receiver);
                    const double nearest = view.isDistant() ? -0.99 / view.wPerUnit : 0.01 * lit.z;
                    const double ahead =
                        glm::mix(nearest, lit.z, std::uniform_real_distribution<double>(0.0, 1.0)(m_random));
                    const double share = view.w(ahead) / view.w(lit.z);
                    const glm::dvec3 between =
                        view.right * (lit.x * share) + view.up * (lit.y * share) + view.ahead * ahead;
                    const double sideways =
                        10.0 * view.texel * static_cast<double>(view.size.width) * view.w(ahead) + 1.0;
                    EXPECT_TRUE(isCaster(view, slice, between));
                    EXPECT_FALSE(isCaster(view, slice, between + sideways * view.right));
                    EXPECT_FALSE(isCaster(view, slice, between + (view.farAhead + 1.0 - ahead) * view.ahead));
                    ++tried;
                }
            }
        }
    }
    EXPECT_GT(tried, 100u);
}

TEST_F(LightViewTest, WhatStandsBeforeNoReceiverIsNoCaster) {
    add({-6.0, 0.0, -20.0}, 1.0f);
    add({6.0, 0.0, -20.0}, 1.0f);
    const std::vector<ReceiverSlice> made = slices();
    ASSERT_EQ(made.size(), 1u);
    for (const glm::dvec3& light : {glm::dvec3(0.0, 1e6, -20.0), glm::dvec3(0.0, 12.0, -20.0)}) {
        const std::vector<LightView> views = viewsOf(light, made[0]);
        ASSERT_EQ(views.size(), 1u);
        const auto isCasterAt = [&](const glm::dvec3& fromCamera) {
            return isCaster(views[0], made[0], (m_camera.position - views[0].origin) + fromCamera);
        };
        EXPECT_FALSE(isCasterAt({0.0, 2.0, -20.0})); // in the middle of the map
        const glm::dvec3 receiver(6.0, 0.0, -20.0);
        EXPECT_TRUE(isCasterAt(glm::mix(receiver, light, 2.0 / light.y)));
    }
}

/// Its middle would be nan, which is in no cell.
TEST_F(LightViewTest, ACellWithoutInstancesHoldsNoCaster) {
    add({0.0, 0.0, -20.0}, 1.0f);
    const ReceiverSlice slice = slices().front();
    const LightView view = viewsOf({1e9, 2e9, -1e9}, slice).front();
    const render::ReceiverCells receivers(view, slice, m_camera.position);
    const render::CasterTest test(view, receivers);
    constexpr double kUnbounded = std::numeric_limits<double>::infinity();
    visibility::InstanceCells::Box box{glm::dvec3(kUnbounded), glm::dvec3(-kUnbounded)};
    EXPECT_FALSE(test.holds(box));
    box = {m_camera.position - 100.0, m_camera.position + 100.0};
    EXPECT_TRUE(test.holds(box));
}

/// The half of a large sphere that the camera does not see needs no shadow.
TEST_F(LightViewTest, OnlyWhatTheLensShowsIsAReceiver) {
    add({500.0, 0.0, -600.0}, 1000.0f);
    const glm::dvec3 light(0.0, 1e9, 0.0);
    std::size_t maps = 0;
    for (const ReceiverSlice& slice : slices()) {
        if (slice.nearView < m_camera.nearView || slice.farView > 1200.0) { // cut, or beyond the sphere's end
            continue;
        }
        for (const LightView& view : viewsOf(light, slice)) {
            const double middle = -0.5 * (slice.nearView + slice.farView);
            const auto isCasterAt = [&](double share) { // of the lens' half width
                const glm::dvec3 fromCamera(share * frustum().tanX * -middle, -middle, middle);
                return isCaster(view, slice, (m_camera.position - view.origin) + fromCamera);
            };
            EXPECT_TRUE(isCasterAt(0.0)) << slice.nearView;
            EXPECT_TRUE(isCasterAt(0.95)) << slice.nearView;
            EXPECT_FALSE(isCasterAt(1.2)) << slice.nearView;
            ++maps;
        }
    }
    EXPECT_GT(maps, 10u);
}

/// A sphere that reaches a little into the side of the view. It and the view's slice both reach behind the light, though what is
/// in both lies in front of it.
TEST_F(LightViewTest, BodiesThatReachBehindALightStillHaveMaps) {
    m_camera.position = glm::dvec3(0.0);
    m_camera.fovY = 2.0 * std::atan(0.5625);
    const std::vector<render::SeenSphere> seen{{glm::dvec3(94.0, 0.0, -24.0), 64.0, 24.0}};
    std::size_t maps = 0;
    for (const ReceiverSlice& slice : render::receiverSlices(m_camera, frustum(), seen)) {
        for (const LightView& view : viewsOf({4.0, 32.2, -24.0}, slice)) {
            EXPECT_TRUE(std::isfinite(view.texel)) << slice.nearView;
            EXPECT_TRUE(std::isfinite(view.low.x) && std::isfinite(view.low.y)) << slice.nearView;
            EXPECT_GE(view.size.width, 1u) << slice.nearView;
            EXPECT_GE(view.size.height, 1u) << slice.nearView;
            ++maps;
        }
    }
    EXPECT_GT(maps, 0u);
}

} // namespace

} // namespace cdr::render_test
