#include "../support/shared_device.h"

#include <cdr/render/renderer.h>
#include <experiments/timing/stages.h>
#include <scenes/cubes.h>

#include <gtest/gtest.h>

namespace {

using namespace cdr;
using experiments::fewPixels;

using StagesDrawn = cdr::test::DeviceTest;

TEST(Stages, FewPixelsKeepTheAspect) {
    EXPECT_EQ(fewPixels({1280, 720}), (vk::Extent2D{16, 9}));
    EXPECT_EQ(fewPixels({720, 720}), (vk::Extent2D{9, 9}));
    EXPECT_EQ(fewPixels({720, 1280}), (vk::Extent2D{9, 16}));
    EXPECT_EQ(fewPixels({1000, 333}), (vk::Extent2D{27, 9}));
    EXPECT_EQ(fewPixels({1, 1}), (vk::Extent2D{9, 9}));
}

/// So a stage is what the pixels cost, and not what other instances do.
TEST_F(StagesDrawn, FewPixelsShowTheSameInstances) {
    const scene::SceneSetup setup = scenes::makeRotation(2013);
    const render::GpuScene gpuScene(device(), setup.scene);
    const auto drawsOf = [&](vk::Extent2D extent) {
        render::RenderOptions options;
        options.width = extent.width;
        options.height = extent.height;
        return render::Renderer(device(), setup.scene, gpuScene, options).draw(setup.path.at(0)).draws;
    };
    EXPECT_EQ(drawsOf({720, 720}), drawsOf(fewPixels({720, 720})));
    EXPECT_EQ(drawsOf({720, 1280}), drawsOf(fewPixels({720, 1280})));
}

} // namespace
