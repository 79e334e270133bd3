#include "fixture.h"

#include <scenes/open_scene.h>

#include <cstdint>

namespace cdr::render_test {

namespace {

using SkipTest = RenderTest;

/// A fitted split keeps to the frames before, and 16 bits of depth show where it cut.
TEST_F(SkipTest, AFrameAfterSkippedOnesIsTheSame) {
    const scene::SceneSetup setup = scenes::openScene("afc-near", 2013).setup;
    const render::GpuScene onDevice(device(), setup.scene);
    render::RenderOptions options = smallOptions({.mapping = depth::Mapping::standard,
                                                  .split = depth::SplitFitted{.most = 2},
                                                  .format = depth::DepthFormat::d16});
    options.motion = true;
    render::Renderer all(device(), setup.scene, onDevice, options);
    render::Renderer few(device(), setup.scene, onDevice, options);
    render::Renderer last(device(), setup.scene, onDevice, options);
    const std::uint32_t frames = 24;
    std::size_t unlikeFirst = 0;
    for (std::uint32_t i = 0; i < frames; ++i) {
        const scene::Camera camera = setup.path.at(i * setup.path.frames / frames);
        const render::Frame expected = all.render(camera);
        if (i % 5 != 4) {
            few.skip(camera);
            continue;
        }
        const render::Frame frame = few.render(camera);
        EXPECT_EQ(hashOf(frame), hashOf(expected)) << i;
        EXPECT_EQ(frame.motion.pixels, expected.motion.pixels) << i;
        last.forgetFrames();
        unlikeFirst += hashOf(last.render(camera)) != hashOf(expected) ? 1 : 0;
    }
    EXPECT_GT(unlikeFirst, 0u) << "no frame depended on those before it";
}

} // namespace

} // namespace cdr::render_test
