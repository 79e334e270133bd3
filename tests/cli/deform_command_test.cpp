#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace cdr::cli_test {

namespace {

constexpr const char* kBendingFile = CDR_SOURCE_DIR "/tests/assets/machine.glb";

nlohmann::json bendingFrames(const TemporaryFolder& folder, const std::string& rest) {
    return documentOf(std::string("render ") + kBendingFile + " --fps 4 --frames 3 --size 96x54" + rest,
                      folder.path());
}

/// Whoever bends skins and morph targets, pictures and the share of wrong pixels are the same, and JSON says who did.
TEST(DeformCommand, PicturesAreTheSameWhoeverDeforms) {
    const TemporaryFolder folder;
    for (const std::string aov : {" --aov color", " --aov wrong"}) {
        const nlohmann::json byCpu = bendingFrames(folder, aov + " --deform cpu");
        EXPECT_EQ(byCpu["options"]["deform"], "cpu");
        if (!deviceInfo().deformMissing.empty()) {
            GTEST_SKIP() << "the device lacks " << deviceInfo().deformMissing.front();
        }
        const nlohmann::json byDevice = bendingFrames(folder, aov + " --deform device");
        EXPECT_EQ(byDevice["options"]["deform"], "device");
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(byDevice["results"][i]["hash"], byCpu["results"][i]["hash"]) << aov << i;
        }
    }
    EXPECT_FALSE(bendingFrames(folder, " --animation 0 --time 0.5")["options"]["deform"].is_null());
}

TEST(DeformCommand, NothingThatDeformsNamesNobody) {
    const TemporaryFolder folder;
    const std::string arguments =
        "render " CDR_SOURCE_DIR "/tests/golden/shapes.gltf --size 32x18 --deform cpu";
    EXPECT_FALSE(documentOf(arguments, folder.path())["options"].contains("deform"));
    expectRefusal("render cubes --size 32x18 --deform gpu", folder.path(), "gpu");
}

} // namespace

} // namespace cdr::cli_test
