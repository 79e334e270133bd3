#include "../support/fault.h"
#include "at_once.h"
#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <numeric>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace cdr::cli_test {

namespace {

using test::Fault;

constexpr std::array<long, 3> kErrors{VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY,
                                      VK_ERROR_DEVICE_LOST};

/// Mesa's layer that sorts devices is not tried: in 22.3.6 it reads a list of extensions that it did not get, and may crash.
const std::string kOthersOff = "NODEVICE_SELECT=1";

/// What of Vulkan a command makes.
enum class Makes { nothing, instance, device };

/// A command at its smallest.
struct Swept {
    const char* arguments;
    const char* name;
    Makes makes = Makes::device;
    const char* lack = nullptr; ///< what a line says that names what the device or the checkout lacks

    std::string command() const { return std::string(arguments).substr(0, std::string(arguments).find(' ')); }
    friend std::ostream& operator<<(std::ostream& out, const Swept& swept) { return out << swept.arguments; }
};

class FaultSweep : public testing::TestWithParam<Swept> {
  protected:
    const std::string m_arguments = std::string(GetParam().arguments) + " --json j.json";

    struct Run {
        ProgramResult result;
        long calls = 0;     ///< that could have failed so
        std::string failed; ///< the call that did
    };
    /// A run of which a call fails, and its folder.
    struct Failing {
        std::unique_ptr<TemporaryFolder> folder = std::make_unique<TemporaryFolder>();
        Run run;
    };

    Run runUnder(const Fault& fault, const TemporaryFolder& folder) const {
        const std::filesystem::path log = folder.path().string() + ".fault";
        Run run{.result = runProgram(m_arguments + " --validate", folder.path(),
                                     "CDR_FAULT_LOG='" + log.string() + "' " + fault.environment() + " " +
                                         kOthersOff + " timeout 1000"),
                .failed = {}};
        std::istringstream(readText(log)) >> run.calls >> run.failed;
        std::filesystem::remove(log);
        return run;
    }
    static void expectAnswered(const Failing& sound);
    static void expectEnded(const Failing& failing, const Failing& sound);
};

/// Which calls to fail: one, in another part of the run and at another call for each command. With CDR_ALL_CASES each.
std::vector<long> chosenOf(long calls, std::size_t salt) {
    if (takesAllCases()) {
        std::vector<long> all(static_cast<std::size_t>(calls));
        std::iota(all.begin(), all.end(), 0L);
        return all;
    }
    constexpr long kParts = 3;
    const long part = static_cast<long>(salt / kErrors.size()) % kParts; // of another digit than the error is
    const long middle = calls * (2 * part + 1) / (2 * kParts);
    // Not the last ones: with several threads a run makes a few calls more or less than another.
    return {(middle + static_cast<long>(salt)) % (calls - calls / 20)};
}

/// Names of files, and the bytes of pictures that show no times.
std::map<std::string, std::string> picturesIn(const TemporaryFolder& folder) {
    std::map<std::string, std::string> pictures = filesIn(folder.path());
    for (auto& [name, bytes] : pictures) {
        const bool isPicture = name.ends_with(".png") || name.ends_with(".exr");
        bytes = isPicture ? std::move(bytes) : "";
    }
    return pictures;
}

/// Status 0 and JSON of what was asked, which names the device that was used.
void FaultSweep::expectAnswered(const Failing& sound) {
    const ProgramResult& result = sound.run.result;
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_FALSE(result.out.empty());
    const auto document = nlohmann::json::parse(readText(sound.folder->path() / "j.json"));
    EXPECT_EQ(document.at("command"), GetParam().command());
    EXPECT_FALSE(document.at("results").empty());
    EXPECT_EQ(document.at("device").at("name") != "", GetParam().makes == Makes::device);
}

/// One line and status 1, or all as without the failure.
void FaultSweep::expectEnded(const Failing& failing, const Failing& sound) {
    const ProgramResult& result = failing.run.result;
    expectWholeFiles(*failing.folder);
    // With all cases, another run may make fewer calls than are to succeed.
    EXPECT_TRUE(failing.run.failed != "none" || (takesAllCases() && result.status == 0));
    if (result.status == 0) {
        EXPECT_EQ(result.err, sound.run.result.err);
        EXPECT_TRUE(picturesIn(*failing.folder) == picturesIn(*sound.folder)) << "other pictures";
        return;
    }
    expectOneLine(result, 1);
    EXPECT_EQ(result.err.find("validation"), std::string::npos) << result.err;
}

/// Each command ends with status 0 and JSON, or says in one line what the device or the checkout lacks. Where any one call
/// fails once, the program prints one line and ends with status 1, or all is as without the failure. Files are whole. There is
/// no validation message, no hang and no crash.
TEST_P(FaultSweep, EveryCallMayFail) {
    if (m_arguments.find("gpu-driven") != std::string::npos && !canDrawGpuDriven()) {
        GTEST_SKIP() << "the device cannot draw gpu-driven";
    }
    std::size_t cases = 0;
    const std::size_t salt = m_arguments.size();
    for (std::size_t kind = 0; kind < kErrors.size(); ++kind) {
        if (!takesAllCases() && kind != (salt + 1) % kErrors.size()) {
            continue;
        }
        const long error = kErrors.at(kind);
        Failing whole;
        whole.run = runUnder({.call = "each", .after = test::kForever, .result = error}, *whole.folder);
        const Run& sound = whole.run;
        if (GetParam().lack != nullptr && sound.result.err.find(GetParam().lack) != std::string::npos) {
            expectOneLine(sound.result, 2);
            GTEST_SKIP() << sound.result.err;
        }
        ASSERT_NO_FATAL_FAILURE(expectAnswered(whole));
        if (sound.calls == 0) {
            EXPECT_LT(GetParam().makes, error == VK_ERROR_DEVICE_LOST ? Makes::device : Makes::instance);
            continue;
        }
        const std::vector<long> chosen = chosenOf(sound.calls, salt);
        for (std::size_t first = 0; first < chosen.size(); first += programsAtOnce()) {
            std::vector<Failing> failing(std::min(programsAtOnce(), chosen.size() - first));
            runAtOnce(failing.size(), [&](std::size_t i) {
                failing[i].run = runUnder({.call = "each", .after = chosen[first + i], .result = error},
                                          *failing[i].folder);
            });
            for (std::size_t i = 0; i < failing.size(); ++i) {
                SCOPED_TRACE(testing::Message()
                             << m_arguments << ": call " << chosen[first + i] << " of " << sound.calls << ", "
                             << failing[i].run.failed << ", " << error);
                expectEnded(failing[i], whole);
            }
            cases += failing.size();
        }
    }
    EXPECT_EQ(cases > 0, GetParam().makes != Makes::nothing);
    RecordProperty("cases", static_cast<int>(cases));
    std::printf("%zu cases\n", cases);
}

const Swept kSweptCommands[] = {
    {"render cubes --size 16x16 -o a.png", "Render"},
    {"render cubes --size 16x16 --frames 2 --threads 2 --technique anchored --targets pool:2 -o a%d.png",
     "Pool"},
    {"render cubes --size 16x16 --technique logcdr --targets one-pass -o a.png", "OnePass"},
    {"render cubes --size 16x16 --submission gpu-driven -o a.png", "GpuDriven"},
    {"render alley --size 32x32 --frames 2 --occlusion-culling -o a%d.png", "OcclusionCulling"},
    {"render alley --size 32x32 --frames 2 --occlusion-culling --submission gpu-driven -o a%d.png",
     "DeviceOcclusion"},
    {"render cubes --size 16x16 --submission primaries -o a.png", "Primaries"},
    {"render cubes --size 16x16 --surface visibility -o a.png", "Visibility"},
    {"render sheets --size 16x16 --translucency sorted -o a.png", "Sorted"},
    {"render cubes --size 16x16 --targets layers --split count:3 --focus 12000:1 -o a.png", "Focus"},
    {"render cubes --size 16x16 --shadows anchored -o a.png", "Shadows"},
    {"render cubes --size 16x16 --antialias edges --occlusion 1 --fog 1e5 -o a.exr", "Effects"},
    {"pictures --scenes cubes --techniques log --size 16x16 --frames 1 --out p", "Pictures"},
    {"flicker --frames 2 --size 16x16 --techniques cdr --state s", "Flicker"},
    {"timing --frames 1 --size 16x16 --modes log --in-flight 2 --csv t.csv", "Timing"},
    {"probe --size 16x16 --techniques standard --formats d32f --distances 10", "Probe"},
    {"translucency --size 16x16 --repeats 1 --cascades 2 --out t", "Translucency"},
    {"render cubes --size 16x16 --stereo parallel --eye-distance 1 -o a.png", "Stereo"},
    {"render cubes --size 16x16 --technique anchored --certify c.json -o a.png", "Certify"},
    {"devices", "Devices", Makes::instance},
    {"precision", "Precision", Makes::nothing},
    {"advise --separation 1", "Advise", Makes::nothing},
    {"orbit --frames 1 --size 16x16 --techniques anchored", "Orbit", Makes::device, "tools/setup.sh"},
    {"scaling --draws 1 --threads 1 --cascades 1 --repeats 1 --size 16x16 --targets single --csv s.csv",
     "Scaling"},
    {"detail cubes --frames 1 --size 16x16", "Detail"},
    {"coplanar --frames 1 --search-views 1 --slopes 0 --constants 0,1 --size 16x16 --techniques reversed",
     "Coplanar"},
    {"shadows cubes --size 16x16", "ShadowsOfMaps"},
    {"effects cubes --frames 1 --size 16x16 --techniques reversed", "EffectsOfPresets"},
    {"focus --frames 1 --cameras 2 --size 16x16", "FocusOfCameras"},
    {"inspect cubes --frames 1 --size 16x16 --techniques standard", "Inspect"},
    {"models " CDR_SOURCE_DIR "/tests/assets/well.gltf --size 16x16", "Models"},
    {"rivals cubes --frames 1 --distances 1 --size 16x16 --techniques anchored --rivals atomic-log", "Rivals",
     Makes::device, "it lacks"},
    {"advise --separation 1 --far 1000 --format d32f --techniques reversed --measured --size 16x16 --frames 1",
     "AdviseMeasured"},
    {"report --smallest --sections precision -o r", "Report"}};

INSTANTIATE_TEST_SUITE_P(Commands, FaultSweep, testing::ValuesIn(kSweptCommands),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(FaultSweepList, HoldsEveryCommand) {
    std::set<std::string> swept{"view", "completions", "manual"}; // see ShellCommands
    for (const Swept& command : kSweptCommands) {
        swept.insert(command.command());
    }
    const std::vector<std::string> names = commandNames();
    EXPECT_EQ(swept, std::set<std::string>(names.begin(), names.end()));
}

using WholeReport = FolderTest;

TEST_F(WholeReport, IsMadeOnTheDevice) {
    if (!takesAllCases()) {
        GTEST_SKIP() << "a minute, with CDR_ALL_CASES; the tests of ranks run a report too";
    }
    const nlohmann::json document = documentOf("report --smallest -o r");
    EXPECT_EQ(document.at("command"), "report");
    EXPECT_FALSE(document.at("results").empty());
    EXPECT_NE(document.at("device").at("name"), "");
}

} // namespace

} // namespace cdr::cli_test
