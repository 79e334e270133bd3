#include "fixture.h"

#include <cdr/base/error.h>
#include <cdr/depth/cascade.h>
#include <cdr/render/effects.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <random>

namespace cdr::render_test {

namespace {

/// Numbers from all of float64, the ends of its range, and usual ones.
class AnyCamera {
  public:
    explicit AnyCamera(std::uint64_t seed) : m_engine(seed) {}

    std::size_t below(std::size_t count) { return static_cast<std::size_t>(m_engine() % count); }
    double any() {
        using Limits = std::numeric_limits<double>;
        switch (below(8)) {
        case 0:
            return std::bit_cast<double>(m_engine());
        case 1:
            return below(2) == 0 ? Limits::denorm_min() : -Limits::max();
        case 2:
            return below(2) == 0 ? Limits::infinity() : 0.0;
        case 3:
            return std::bit_cast<float>(static_cast<std::uint32_t>(m_engine()));
        default:
            return (below(2) == 0 ? 1.0 : -1.0) * spread(1e-45, 1e45);
        }
    }
    double spread(double low, double high) {
        return std::exp(std::uniform_real_distribution<>(std::log(low), std::log(high))(m_engine));
    }
    /// One in four numbers is any at all, else it is usable.
    double mostly(double low, double high) { return below(4) == 0 ? any() : spread(low, high); }

    scene::Camera next() {
        scene::Camera camera{
            .fovY = mostly(1e-12, 3.14), .nearView = mostly(1e-30, 1e3), .farView = mostly(1.0, 1e30)};
        const glm::dvec3 forward(any(), any(), mostly(1e-3, 1.0));
        const glm::dvec3 eye(mostly(1e-3, 1e20), any(), mostly(1e-3, 1e20));
        return below(3) == 0 ? camera : scene::lookAlong(camera, eye, forward);
    }

  private:
    std::mt19937_64 m_engine;
};

/// Things from microns to light years, about the origin and far from it.
scene::Scene spreadScene() {
    scene::Scene scene = boxScene();
    for (int power = -6; power <= 16; power += 2) {
        const double size = std::pow(10.0, power);
        addBox(scene, glm::dvec3(0.0, 0.0, -3.0 * size), glm::mat3(static_cast<float>(size)));
    }
    return scene;
}

/// Any camera gives a frame with possible numbers, or base::InputError. There is no validation message; the fixture fails on
/// one. It is no more work than a frame: each case has ten seconds of the CPU, a thousand times what it takes.
TEST_F(RenderTest, WholeRangeOfCamerasEndsInAFrameOrIsRefused) {
    const char* asked = std::getenv("CDR_CASES");
    const int cases = asked != nullptr ? std::atoi(asked) : 200;
    const scene::Scene scene = spreadScene();
    const render::GpuScene gpuScene(device(), scene);
    AnyCamera random(7);
    int drawn = 0;
    for (const char* technique :
         {"standard", "log", "logcdr", "reversed", "anchored", "anchored-reversed/fitted:1px",
          "log-fragment/minimax:3", "standard/ratio:1e3"}) {
        const render::RenderOptions options = smallOptions(depth::parseTechnique(technique), 16, 9);
        render::Renderer renderer(device(), scene, gpuScene, options);
        for (int i = 0; i < cases; ++i) {
            const std::clock_t start = std::clock();
            SCOPED_TRACE(testing::Message() << technique << " case " << i);
            try {
                const scene::Camera camera = random.next();
                const bool isUsable = camera.nearView >= depth::kMinView &&
                                      camera.farView > camera.nearView && camera.farView <= depth::kMaxView &&
                                      camera.farView <= depth::kMaxFarOverNear * camera.nearView &&
                                      camera.fovY > 0.0 && camera.fovY < 3.2 &&
                                      std::isfinite(glm::length(camera.position / 1e200));
                const render::Frame frame = renderer.render(camera);
                ++drawn;
                ASSERT_TRUE(isUsable)
                    << "near " << camera.nearView << " far " << camera.farView << " fov " << camera.fovY;
                for (std::uint32_t y = 0; y < frame.height(); ++y) {
                    for (std::uint32_t x = 0; x < frame.width(); ++x) {
                        ASSERT_LE(frame.id(x, y), scene.instances.size());
                        ASSERT_FALSE(std::isnan(frame.distanceView(x, y)));
                    }
                }
            } catch (const base::InputError&) {
            }
            ASSERT_LT(std::clock() - start, 10 * CLOCKS_PER_SEC);
        }
    }
    EXPECT_GT(drawn, 8 * cases / 10);
}

/// The same for the numbers of effects, each in a renderer of its own.
TEST_F(RenderTest, WholeRangeOfEffectsEndsInAFrameOrIsRefused) {
    const char* asked = std::getenv("CDR_CASES");
    const int cases = (asked != nullptr ? std::atoi(asked) : 200) / 4;
    const scene::Scene scene = spreadScene();
    const render::GpuScene gpuScene(device(), scene);
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 1e9};
    AnyCamera random(8);
    int drawn = 0;
    for (int i = 0; i < cases; ++i) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"), 16, 9);
        const bool hasLens = random.below(2) == 0;
        if (hasLens) {
            options.targets = render::TargetsKind::layers;
            options.focus = {.distance = random.mostly(1e-6, 1e12),
                             .aperture = random.mostly(1e-9, 1e6),
                             .blend = random.below(2) == 0};
        } else {
            options.effects.occlusion.radius = random.mostly(1e-6, 1e12);
        }
        options.effects.fog = {.visibility = random.mostly(1e-6, 1e12),
                               .color = glm::vec3(static_cast<float>(random.mostly(1e-6, 1.0)))};
        SCOPED_TRACE(testing::Message()
                     << "case " << i << " focus " << options.focus.distance << " " << options.focus.aperture
                     << " occlusion " << options.effects.occlusion.radius << " fog "
                     << options.effects.fog.visibility);
        const std::clock_t start = std::clock();
        try {
            draw(scene, camera, options);
            ++drawn;
            for (const double number :
                 {options.focus.distance, options.focus.aperture, options.effects.occlusion.radius,
                  options.effects.fog.visibility, double{options.effects.fog.color.x}}) {
                ASSERT_TRUE(std::isfinite(number) && number >= 0.0) << number;
            }
        } catch (const base::InputError&) {
        }
        ASSERT_LT(std::clock() - start, 10 * CLOCKS_PER_SEC);
    }
    EXPECT_GT(drawn, cases / 10);
}

} // namespace

} // namespace cdr::render_test
