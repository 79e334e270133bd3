#include "../support/synthetic_earth.h"
#include "fixture.h"
#include "snapping.h"

#include <scenes/earth/earth.h>

namespace cdr::render_test {
namespace {

/// With air and the painted ground, and with shadows as its pictures have them.
class Earth : public RenderTest {};

TEST_F(Earth, AnchoredIsRightOnTheWholeWayDown) {
    const scene::SceneSetup setup = scenes::makeEarth(test::syntheticEarth(), nullptr, {.blockTexels = 64});
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"), 320, 180);
    options.shadows.method = render::ShadowMethod::anchored;
    for (const std::uint32_t frame : {0u, 60u, 120u, 180u, 239u}) {
        const scene::Camera camera = setup.path.at(frame);
        const image::ImageU32 ids = draw(setup.scene, camera, options).ids();
        const measure::TruthImage truth = truthOf(setup.scene, camera, options.width, options.height);
        EXPECT_GT(measure::countWrong(ids, truth).pixels, 30'000u) << frame;
        EXPECT_EQ(wrongBeyond(ids, truth, snapReach(device())), 0u) << frame;
    }
}

} // namespace
} // namespace cdr::render_test
