#include <experiments/inspect/verdict.h>

#include <gtest/gtest.h>

namespace cdr::experiments {
namespace {

/// Or a file could move the cursor of a terminal that shows what its surfaces are called.
TEST(Verdict, NamesOfObjectsAreOneLine) {
    scene::Scene scene;
    scene.objectNames = {"trunk", "a\x1b[2J\nb", ""};
    EXPECT_EQ(nameOfObject(scene, 0), "trunk");
    EXPECT_EQ(nameOfObject(scene, 1), "a [2J b");
    EXPECT_EQ(nameOfObject(scene, 2), "object 2");
    EXPECT_EQ(nameOfObject(scene, 3), "object 3");
}

} // namespace
} // namespace cdr::experiments
