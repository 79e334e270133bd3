#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace cdr::cli_test {

namespace {

class DeformCommand : public FolderTest {
  protected:
    nlohmann::json bendingFrames(const std::string& rest) const {
        return documentOf(
            "render " CDR_SOURCE_DIR "/tests/assets/machine.glb --fps 4 --frames 3 --size 96x54" + rest);
    }
};

/// Whoever bends skins and morph targets, pictures and the share of wrong pixels are the same, and JSON says who did.
TEST_F(DeformCommand, PicturesAreTheSameWhoeverDeforms) {
    for (const std::string aov : {" --aov color", " --aov wrong"}) {
        const nlohmann::json byCpu = bendingFrames(aov + " --deform cpu");
        EXPECT_EQ(byCpu["options"]["deform"], "cpu");
        if (!deviceInfo().deformMissing.empty()) {
            GTEST_SKIP() << "the device lacks " << deviceInfo().deformMissing.front();
        }
        const nlohmann::json byDevice = bendingFrames(aov + " --deform device");
        EXPECT_EQ(byDevice["options"]["deform"], "device");
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(byDevice["results"][i]["hash"], byCpu["results"][i]["hash"]) << aov << i;
        }
    }
    EXPECT_FALSE(bendingFrames(" --animation 0 --time 0.5")["options"]["deform"].is_null());
}

TEST_F(DeformCommand, NothingThatDeformsNamesNobody) {
    const std::string arguments =
        "render " CDR_SOURCE_DIR "/tests/golden/shapes.gltf --size 32x18 --deform cpu";
    EXPECT_FALSE(documentOf(arguments)["options"].contains("deform"));
    expectRefusal("render cubes --size 32x18 --deform gpu", "gpu");
}

} // namespace

} // namespace cdr::cli_test
