#include "../../support/all_cases.h"
#include "../../support/globe.h"
#include "../fixture.h"
#include "../snapping.h"

#include <scenes/cubes.h>
#include <scenes/mixed.h>

#include <string>
#include <vector>

namespace cdr::render_test {

namespace {

class AnchoredTargetsTest : public RenderTest {
  protected:
    static depth::Technique technique(depth::Mapping mapping, depth::DepthFormat format) {
        return depth::Technique{mapping, depth::SplitFitted{}, format};
    }

    /// One image from single, accumulate, pool and layers on any number of threads, and no wrong pixel in
    /// one-pass.
    void expectRight(const scene::Scene& scene, const scene::Camera& camera, std::size_t leastCascades) {
        const render::GpuScene gpuScene(device(), scene);
        const auto truth = truthOf(scene, camera);
        std::size_t turn = 0;
        for (const depth::Mapping mapping : {depth::Mapping::anchored, depth::Mapping::anchoredReversed}) {
            for (const auto format : available({depth::DepthFormat::d24, depth::DepthFormat::d32f})) {
                std::string first;
                for (const char* targets : {"single", "accumulate", "pool:3", "layers", "one-pass"}) {
                    for (const std::size_t threads :
                         test::sampleOf(std::vector<std::size_t>{1, 2, 5}, turn++)) {
                        auto options = smallOptions(technique(mapping, format));
                        options.targets = render::parseTargets(targets);
                        options.threads = threads;
                        const render::Frame frame = draw(scene, gpuScene, camera, options);
                        EXPECT_GE(frame.cascades.size(), leastCascades);
                        const std::string where = nameOf(options.technique) + " " + targets;
                        if (std::string(targets) == "one-pass") {
                            EXPECT_GT(measure::countWrong(frame.ids(), truth).pixels, 10'000u);
                            EXPECT_EQ(wrongBeyond(frame.ids(), truth, snapReach(device())), 0u) << where;
                            continue;
                        }
                        first = first.empty() ? hashOf(frame) : first;
                        EXPECT_EQ(hashOf(frame), first) << where << " " << threads;
                    }
                }
            }
        }
    }
};

TEST_F(AnchoredTargetsTest, SomethingNearAndAFieldAMillionUnitsAway) {
    const scene::SceneSetup setup = scenes::makeAfcNear(2013);
    expectRight(setup.scene, setup.path.at(7), 2);
}

TEST_F(AnchoredTargetsTest, MixedDistances) {
    const scene::SceneSetup setup = scenes::makeMixed();
    expectRight(setup.scene, setup.path.at(0), 4);
}

TEST_F(AnchoredTargetsTest, PiecesOfOneObject) {
    const scene::Scene scene = test::makeGlobe({.cells = 48});
    const double radius = test::GlobeOptions{}.radius;
    const scene::Camera camera = scene::lookAt({.fovY = 0.8, .nearView = 0.1, .farView = 1e8},
                                               {0.0, 0.0, radius + 420e3}, {0.0, 2e6, radius - 3e5});
    expectRight(scene, camera, 2);
}

} // namespace

} // namespace cdr::render_test
