#include "../support/synthetic_earth.h"
#include "fixture.h"
#include "snapping.h"

#include <scenes/orbit/orbit.h>

#include <map>

namespace cdr::render_test {
namespace {

class Orbit : public RenderTest {
  protected:
    /// Wrong pixels, but those that the device's snapping of vertices explains.
    measure::WrongPixels wrongAt(std::uint32_t frame, const char* technique) {
        static const scene::SceneSetup setup = scenes::makeOrbit(test::syntheticEarth());
        const scene::Camera camera = setup.path.at(frame);
        const image::ImageU32 ids =
            draw(setup.scene, camera, smallOptions(depth::parseTechnique(technique), 320, 180)).ids();
        static std::map<std::uint32_t, measure::TruthImage> truths; // by frame
        measure::TruthImage& truth = truths[frame];
        if (truth.pixels.empty()) {
            truth = truthOf(setup.scene, camera, 320, 180);
        }
        measure::WrongPixels wrong = measure::countWrong(ids, truth);
        wrong.wrong = wrongBeyond(ids, truth, snapReach(device()));
        return wrong;
    }
};

/// 5 mm of paint 430 km away: 1.2e-8 of the distance, past what a float32 of it holds.
TEST_F(Orbit, OnlyAnchoredReadsTheNumbers) {
    const measure::WrongPixels anchored = wrongAt(239, "anchored");
    EXPECT_GT(anchored.pixels, 40'000u);
    EXPECT_EQ(anchored.wrong, 0u);
    for (const char* technique : {"standard", "cdr", "log", "logcdr", "reversed"}) {
        EXPECT_GT(wrongAt(239, technique).fraction(), 0.02) << technique;
    }
}

TEST_F(Orbit, AnchoredIsRightFromTheWindowOn) {
    for (const std::uint32_t frame : {0u, 60u, 120u, 180u, 210u}) {
        const measure::WrongPixels wrong = wrongAt(frame, "anchored");
        EXPECT_GT(wrong.pixels, 30'000u) << frame;
        EXPECT_LE(wrong.wrong, 1u) << frame;
    }
}

} // namespace
} // namespace cdr::render_test
