#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace cdr::cli_test {
namespace {

using nlohmann::json;

/// A command at its smallest.
struct SmallRun {
    const char* name; ///< as GoogleTest takes it
    const char* arguments;
    const char* refusal = nullptr; ///< in the one line of a device or a checkout that cannot serve it
    bool usesDevice = true;        ///< one, which its JSON names
};

void PrintTo(const SmallRun& run, std::ostream* out) {
    *out << run.arguments;
}

const SmallRun kSmallRuns[] = {
    {"Render", "render cubes --size 16x16 -o a.png"},
    {.name = "Devices", .arguments = "devices", .usesDevice = false},
    {.name = "Precision", .arguments = "precision", .usesDevice = false},
    {"Pictures", "pictures --scenes cubes --techniques log --frames 1 --size 32x18 --out p"},
    {"Flicker", "flicker --frames 2 --size 32x18 --techniques cdr"},
    {"Probe", "probe --distances 10 --techniques log --formats d32f --size 16x16"},
    {.name = "Advise", .arguments = "advise --separation 1", .usesDevice = false},
    {"AdviseMeasured", "advise --separation 1 --far 1000 --format d32f --measured --size 320x180 --frames 1"},
    {"Timing", "timing --frames 1 --size 16x16 --modes log"},
    {"Scaling", "scaling --draws 100 --cascades 2 --repeats 1"},
    {"Detail", "detail cubes --frames 1 --size 32x18"},
    {"Coplanar", "coplanar --frames 1 --search-views 1 --size 32x18 --techniques reversed"},
    {"Translucency", "translucency --cascades 2 --size 32x18 --repeats 1"},
    {"Shadows", "shadows alley --size 32x18"},
    {"Effects", "effects --frames 1 --size 32x18"},
    {"Focus", "focus --frames 1 --size 32x18 --cameras 2"},
    {"Orbit", "orbit --frames 1 --size 32x18 --techniques anchored", "tools/setup.sh"},
    {"Inspect", "inspect cubes --frames 1 --size 32x18"},
    {"Models", "models " CDR_SOURCE_DIR "/tests/assets/well.gltf --size 32x18"},
    {"Rivals", "rivals cubes --frames 1 --distances 1 --size 16x16 --techniques anchored --rivals atomic-log",
     "it lacks"},
    {"Report", "report --smallest -o r"}};

class EveryCommand : public FolderTest, public testing::WithParamInterface<SmallRun> {};

/// It ends with status 0 and JSON on every device that has what it needs. Elsewhere it says in one line what is missing.
TEST_P(EveryCommand, RunsOnTheDevice) {
    const std::string command =
        std::string(GetParam().arguments).substr(0, std::string(GetParam().arguments).find(' '));
    if (command == "report" && !takesAllCases()) {
        GTEST_SKIP() << "a minute, with CDR_ALL_CASES; the tests of ranks run a report too";
    }
    const ProgramResult result = run(std::string(GetParam().arguments) + " --json j.json");
    const char* refusal = GetParam().refusal;
    if (result.status == 2 && refusal != nullptr && result.err.find(refusal) != std::string::npos) {
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        GTEST_SKIP() << result.err;
    }
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_FALSE(result.out.empty());
    const json document = jsonIn("j.json");
    EXPECT_EQ(document.at("command"), command);
    EXPECT_FALSE(document.at("results").empty());
    EXPECT_NE(document.at("device").at("name").get<std::string>().empty(), GetParam().usesDevice);
}

INSTANTIATE_TEST_SUITE_P(Commands, EveryCommand, testing::ValuesIn(kSmallRuns),
                         [](const auto& run) { return std::string(run.param.name); });

TEST(EveryCommandList, HoldsEveryCommand) {
    std::set<std::string> run{"view", "completions", "manual"}; // draw nothing themselves, see ShellCommands
    for (const SmallRun& small : kSmallRuns) {
        run.insert(std::string(small.arguments).substr(0, std::string(small.arguments).find(' ')));
    }
    const std::vector<std::string> names = commandNames();
    EXPECT_EQ(run, std::set<std::string>(names.begin(), names.end()));
}

} // namespace
} // namespace cdr::cli_test
