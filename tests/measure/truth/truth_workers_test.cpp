#include "../test_scenes.h"

#include <gtest/gtest.h>

namespace cdr::test {

TEST(TruthWorkers, SameBitsForAnyNumber) {
    const scene::Scene scene = makeRandomScene(11, 3000, 60.0, {0.0, 0.0, 0.0});
    scene::Camera camera = makePlainCamera();
    camera.nearView = 0.01;
    const measure::TruthImage expected = cast(scene, camera, 161, 97);
    for (const std::size_t threads : {1u, 2u, 3u, 8u}) {
        platform::WorkerPool workers(threads);
        const measure::TruthCaster caster(scene, workers);
        for (int repeat = 0; repeat < 3; ++repeat) {
            EXPECT_EQ(caster.cast(camera, 161, 97, workers), expected) << threads << " threads";
        }
    }
}

TEST(TruthWorkers, TheOrderOfInstancesDoesNotMatter) {
    const scene::Scene scene = makeRandomScene(12, 300, 20.0, {0.0, 0.0, -15.0});
    scene::Scene reversed = makeEmptyScene();
    const scene::Instances& instances = scene.instances;
    for (std::size_t i = instances.size(); i-- > 0;) {
        scene::addInstance(reversed, instances.mesh[i], instances.material[i], instances.object[i],
                           instances.position(i), instances.basis[i]);
    }
    EXPECT_EQ(cast(reversed, makePlainCamera(), 96, 54), cast(scene, makePlainCamera(), 96, 54));
}

} // namespace cdr::test
