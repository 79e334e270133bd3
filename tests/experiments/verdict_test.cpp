#include <experiments/inspect/verdict.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

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

/// Of a thousand pixels.
InspectedTechnique inspected(const char* preset, std::uint64_t wrong, double undecided) {
    InspectedTechnique technique;
    technique.name = preset;
    technique.technique = depth::parseTechnique(preset);
    technique.wrong.pixels = 1000;
    technique.wrong.wrong = wrong;
    technique.undecided = undecided;
    return technique;
}

/// Not one that was lucky.
TEST(Verdict, TheBestTechniqueHasFewestWrongOrUndecidedPixels) {
    Inspection inspection;
    inspection.techniques = {inspected("standard", 0, 400.0), inspected("log", 3, 0.5)};
    inspection.objectPixels = 1000;
    EXPECT_EQ(
        explain(inspection, {}).front(),
        "No technique is enough: log with d32f is the best, with 3 of 1000 object pixels wrong, 0.3 %.");
}

/// Undecided ones are partly the wrong ones.
TEST(Verdict, NoPixelCountsTwiceAgainstATechnique) {
    Inspection inspection;
    inspection.techniques = {inspected("standard", 250, 0.0), inspected("log", 100, 200.0)};
    inspection.objectPixels = 1000;
    const std::string said = explain(inspection, {}).front();
    EXPECT_TRUE(said.starts_with("No technique is enough: log with d32f is the best")) << said;
}

} // namespace
} // namespace cdr::experiments
