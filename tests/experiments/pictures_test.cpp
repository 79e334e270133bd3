#include <cdr/gpu/device.h>
#include <cdr/gpu/instance.h>
#include <experiments/pictures/pictures.h>
#include <scenes/cubes.h>

#include <gtest/gtest.h>

#include <utility>

namespace cdr::experiments {
namespace {

/// What is left is told by them: a still scene has one frame, however many are asked for.
TEST(Pictures, ProgressCountsTheFramesThatScenesHave) {
    const gpu::Instance instance;
    const gpu::Device device(instance, "");
    std::vector<scene::SceneSetup> scenes;
    scenes.push_back(scenes::makeCubes(2013));
    scenes.push_back(scenes::makeAfc(2013));
    std::vector<std::pair<std::size_t, std::size_t>> steps;
    runPictures(
        device, std::move(scenes),
        {.width = 32, .height = 18, .frames = 2, .techniques = {depth::namedTechnique("standard")}},
        [&](std::size_t done, std::size_t all, const std::string&) { steps.emplace_back(done, all); });
    EXPECT_EQ(steps, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 3}, {1, 3}, {2, 3}}));
}

} // namespace
} // namespace cdr::experiments
