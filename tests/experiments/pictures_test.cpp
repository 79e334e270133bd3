#include <cdr/gpu/device.h>
#include <cdr/gpu/instance.h>
#include <cdr/image/image.h>
#include <experiments/models/model_sheet.h>
#include <experiments/pictures/pictures.h>
#include <scenes/cubes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
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
        {.drawing = {.width = 32, .height = 18},
         .frames = 2,
         .techniques = {depth::namedTechnique("standard")}},
        [&](std::size_t done, std::size_t all, const std::string&) { steps.emplace_back(done, all); });
    EXPECT_EQ(steps, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 3}, {1, 3}, {2, 3}}));
}

/// Lower than the factor that would make them as wide as a cell.
TEST(Pictures, SheetsTakeLowAndWideOnes) {
    for (const auto& [width, height] : {std::pair(640u, 1u), std::pair(1280u, 3u), std::pair(1280u, 720u)}) {
        const image::ImageRgba8 white(width, height, {255, 255, 255, 255});
        PictureResult picture;
        picture.picture = white;
        picture.heatMap = white;
        ModelResult model;
        model.plain = model.picture = model.reference = model.difference = white;
        const std::uint32_t across = width / std::min(width / 320, height);
        EXPECT_EQ(makeContactSheet({picture}, "").width, 8 + across + 8) << width;
        EXPECT_EQ(makeModelSheet({model}, "").width, 8 + 4 * (across + 8)) << width;
    }
}

} // namespace
} // namespace cdr::experiments
