#include "program.h"

#include <gtest/gtest.h>

namespace cdr::cli_test {
namespace {

using OrbitCommand = FolderTest;

TEST_F(OrbitCommand, MissingMapsAreOneLineAndLeaveNothing) {
    expectRefusal("orbit --data nowhere --out pictures", "tools/setup.sh");
    EXPECT_FALSE(std::filesystem::exists(at("pictures")));
    expectRefusal("render orbit -o a.png", "nowhere/earth-blue-marble.jpg", "CDR_ORBIT_DATA=nowhere");
    expectRefusal("render orbit -o a.png", "tools/setup.sh", "CDR_ORBIT_DATA=" + std::string(300, 'x'));
}

TEST_F(OrbitCommand, MeasuresTheZoom) {
    if (!std::filesystem::exists(CDR_SOURCE_DIR "/.cache/orbit-data")) {
        GTEST_SKIP() << "the Earth of the scene orbit is not installed; tools/setup.sh fetches it";
    }
    const auto document = documentOf("--validate orbit --frames 2 --size 160x90 --techniques "
                                     "reversed,anchored --out pictures --plot pictures/plot.svg");
    const auto& rows = document["results"];
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0]["frame"], 0);
    EXPECT_NEAR(rows[0]["fov_degrees"].get<double>(), 60.0, 1e-9);
    EXPECT_EQ(rows[2]["technique"], "reversed");
    EXPECT_NEAR(rows[2]["fov_degrees"].get<double>(), 0.002, 1e-12);
    EXPECT_GT(rows[2]["wrong_fraction"].get<double>(), 0.02);
    EXPECT_EQ(rows[3]["technique"], "anchored");
    EXPECT_EQ(rows[3]["wrong"], 0);
    EXPECT_GT(rows[3]["pixels"].get<int>(), 5000);
    for (const char* file :
         {"orbit_window.png", "orbit_reversed.png", "orbit_anchored_wrong.png", "orbit_sheet.png"}) {
        EXPECT_TRUE(std::filesystem::exists(at("pictures") / file)) << file;
    }
}

} // namespace
} // namespace cdr::cli_test
