#include "../failing_calls.h"
#include "../fixture.h"
#include "host_side.h"

namespace cdr::render_test {

namespace {

constexpr double kHalfSide = 8.0;
constexpr std::uint32_t kWall = 10;
constexpr int kDark = 180; // of the wall's blue, which is 120 in shadow and above 230 in light

class HostShadowsTest : public RenderTest {
  protected:
    static render::RenderOptions shadowed() {
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.shadows.method = render::ShadowMethod::anchored;
        return options;
    }

    /// A box, and the light that throws its shadow behind it.
    static scene::Scene boxBeforeAWall() {
        scene::Scene scene = boxScene();
        addBox(scene, {0.0, 0.0, -5.0});
        scene.lights.front() = {.position = {0.3, 0.6, 3.0}, .halfDistance = 1e3};
        return scene;
    }

    /// Which pixels of a wall of the scene's are shadowed. The wall faces the camera.
    image::Raster<char> shadowOnOwnWall(double wallView) {
        scene::Scene scene = boxBeforeAWall();
        addBox(scene, {0.0, 0.0, -wallView - kHalfSide}, glm::mat3(static_cast<float>(2.0 * kHalfSide)));
        const render::Frame frame = draw(scene, m_camera, shadowed());
        image::Raster<char> dark(frame.litMask.width, frame.litMask.height);
        for (std::uint32_t y = 0; y < dark.height; ++y) {
            for (std::uint32_t x = 0; x < dark.width; ++x) {
                dark.at(x, y) = frame.id(x, y) == 2 && frame.litMask.at(x, y)[0] == 0 ? 1 : 0;
            }
        }
        return dark;
    }

    /// The same of a wall that a host draws.
    image::Raster<char> shadowOnHostsWall(double wallView) {
        const render::RenderOptions options = shadowed();
        const vk::Extent2D extent{options.width, options.height};
        const scene::Scene scene = boxBeforeAWall();
        const HostRectangles wall(device(), vk::Format(device().depthFormat(options.technique.format)));
        HostSide host(device(), extent);
        SoleRenderer renderer(device(), scene, options);
        render::HostFrame frame = host.begin();
        frame.occupied = {{wallView, wallView}};
        frame.draw = [&](const render::HostCascade& cascade) {
            wall.draw(cascade, HostRectangles::Square{0.0, wallView, kHalfSide, kWall});
        };
        host.submit(renderer, m_camera, frame);
        const auto pixels = readGBuffer(device(), renderer.surfaces().gbuffer);
        const auto colors = host.color<image::Rgba8>();
        image::Raster<char> dark(extent.width, extent.height);
        for (std::uint32_t y = 0; y < extent.height; ++y) {
            for (std::uint32_t x = 0; x < extent.width; ++x) {
                dark.at(x, y) = pixels.at(x, y).id() == kWall + 1 && colors.at(x, y)[2] < kDark ? 1 : 0;
            }
        }
        return dark;
    }

    const scene::Camera m_camera{.fovY = 1.0, .nearView = 0.1, .farView = 1e3};
};

/// Right behind the box, in the next slice of distances, and far beyond all that the scene holds.
TEST_F(HostShadowsTest, AHostsSurfaceIsShadowedAsTheScenesOwnIs) {
    for (const double wallView : {6.0, 7.5, 12.0, 40.0}) {
        const image::Raster<char> own = shadowOnOwnWall(wallView);
        const image::Raster<char> hosts = shadowOnHostsWall(wallView);
        int shadowed = 0;
        int different = 0;
        for (std::uint32_t y = 0; y < own.height; ++y) {
            for (std::uint32_t x = 0; x < own.width; ++x) {
                shadowed += own.at(x, y);
                different += own.at(x, y) != hosts.at(x, y) ? 1 : 0;
            }
        }
        EXPECT_GT(shadowed, 50) << wallView;
        EXPECT_LE(different, shadowed / 20) << wallView; // at edges
    }
}

/// Depth of shadow maps, slices, occluders and hosts. An engine's device may lack the feature that layouts of depth alone need.
TEST_F(HostShadowsTest, NoLayoutIsOfDepthAlone) {
    scene::Scene scene = boxBeforeAWall();
    addBox(scene, {0.0, 0.0, -6.0 - kHalfSide}, glm::mat3(static_cast<float>(2.0 * kHalfSide)));
    render::RenderOptions options = shadowed();
    HostSide host(device(), {options.width, options.height});
    const DepthLayouts before = depthLayouts();
    SoleRenderer renderer(device(), scene, options);
    render::HostFrame frame = host.begin();
    frame.depth = host.depth(0.1);
    host.submit(renderer, m_camera, frame);
    renderer.finish();
    EXPECT_GT(renderer.lastStats().shadows.maps, 0u);
    options.occlusionCulling = true;
    EXPECT_GT(draw(scene, m_camera, options).stats.occluders.draws, 0u);
    EXPECT_EQ(depthLayouts().separate, before.separate);
    EXPECT_GT(depthLayouts().whole, before.whole);
}

} // namespace

} // namespace cdr::render_test
