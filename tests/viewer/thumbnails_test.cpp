#include "viewer_run.h"

#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace cdr::viewer_test {

namespace {

constexpr std::uint32_t kWidth = 160;
constexpr std::uint32_t kHeight = 90;

/// Sum over all channels; of a sheet only the tile, in reading order.
std::uint64_t distance(const image::ImageRgba8& picture, const image::ImageRgba8& sheet, std::uint32_t tile) {
    const std::uint32_t columns = sheet.width / kWidth;
    const std::uint32_t left = tile % columns * kWidth;
    const std::uint32_t top = tile / columns * kHeight;
    std::uint64_t sum = 0;
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                sum += static_cast<std::uint64_t>(
                    std::abs(picture.at(x, y)[channel] - sheet.at(left + x, top + y)[channel]));
            }
        }
    }
    return sum;
}

/// Thumbnails are in the order of the list, one for each scene. Each scene, drawn again, is most like its own. The Earth
/// takes as long to open as all others together, so it is drawn only with CDR_ALL_CASES.
TEST(Thumbnails, ShowTheScenesBesideWhichTheyStand) {
    const test::TemporaryFolder folder;
    const image::ImageRgba8 sheet = readPicture(CDR_SOURCE_DIR "/src/viewer/panels/scenes.jpg");
    const auto scenes = scenes::generatedScenes();
    ASSERT_EQ(sheet.width / kWidth * (sheet.height / kHeight), scenes.size());
    for (std::uint32_t scene = 0; scene < scenes.size(); ++scene) {
        if (scenes[scene] == "earth" && std::getenv("CDR_ALL_CASES") == nullptr) {
            continue;
        }
        const RunResult run =
            runShell(fmt::format("'" CDR_PROGRAM
                                 "' render {} --technique anchored --colours bright --size {}x{} -o a.png",
                                 scenes[scene], kWidth, kHeight),
                     folder.path(), "");
        ASSERT_EQ(run.status, 0) << run.err;
        const image::ImageRgba8 picture = readPicture(folder.path() / "a.png");
        std::uint32_t nearest = 0;
        for (std::uint32_t tile = 1; tile < scenes.size(); ++tile) {
            nearest = distance(picture, sheet, tile) < distance(picture, sheet, nearest) ? tile : nearest;
        }
        EXPECT_EQ(scenes[nearest], scenes[scene]);
    }
}

} // namespace

} // namespace cdr::viewer_test
