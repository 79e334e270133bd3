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

/// A command at its smallest.
struct Swept {
    const char* command;
    const char* name;

    friend std::ostream& operator<<(std::ostream& out, const Swept& swept) { return out << swept.command; }
};

class FaultSweep : public testing::TestWithParam<Swept> {
  protected:
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
        Run run{.result = runProgram(std::string(GetParam().command) + " --validate", folder.path(),
                                     "CDR_FAULT_LOG='" + log.string() + "' " + fault.environment() + " " +
                                         kOthersOff + " timeout 1000"),
                .failed = {}};
        std::istringstream(readText(log)) >> run.calls >> run.failed;
        std::filesystem::remove(log);
        return run;
    }
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

/// Whether a line names what the device or the checkout lacks.
bool isLack(const std::string& line) {
    return line.find("it lacks") != std::string::npos || line.find("tools/setup.sh") != std::string::npos;
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

/// Any one call fails once. Then the program prints one line and ends with status 1, or all is as without the failure. Files
/// are whole. There is no validation message, no hang and no crash.
TEST_P(FaultSweep, EveryCallMayFail) {
    if (std::string(GetParam().command).find("gpu-driven") != std::string::npos && !canDrawGpuDriven()) {
        GTEST_SKIP() << "the device cannot draw gpu-driven";
    }
    std::size_t cases = 0;
    const std::size_t salt = std::string(GetParam().command).size();
    for (std::size_t kind = 0; kind < kErrors.size(); ++kind) {
        if (!takesAllCases() && kind != (salt + 1) % kErrors.size()) {
            continue;
        }
        const long error = kErrors.at(kind);
        Failing whole;
        whole.run = runUnder({.call = "each", .after = test::kForever, .result = error}, *whole.folder);
        const Run& sound = whole.run;
        if (sound.result.status != 0 && isLack(sound.result.err)) {
            GTEST_SKIP() << sound.result.err;
        }
        ASSERT_EQ(sound.result.status, 0) << sound.result.err;
        if (sound.calls == 0) {
            EXPECT_EQ(error, VK_ERROR_DEVICE_LOST);
            EXPECT_EQ(std::string(GetParam().name), "Devices") << "which makes no device";
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
                             << GetParam().command << ": call " << chosen[first + i] << " of " << sound.calls
                             << ", " << failing[i].run.failed << ", " << error);
                expectEnded(failing[i], whole);
            }
            cases += failing.size();
        }
    }
    EXPECT_GT(cases, 0u);
    RecordProperty("cases", static_cast<int>(cases));
    std::printf("%zu cases\n", cases);
}

INSTANTIATE_TEST_SUITE_P(
    Commands, FaultSweep,
    testing::Values(
        Swept{"render cubes --size 16x16 -o a.png --json a.json", "Render"},
        Swept{
            "render cubes --size 16x16 --frames 2 --threads 2 --technique anchored --targets pool:2 -o a%d.png",
            "Pool"},
        Swept{"render cubes --size 16x16 --technique logcdr --targets one-pass -o a.png", "OnePass"},
        Swept{"render cubes --size 16x16 --submission gpu-driven -o a.png", "GpuDriven"},
        Swept{"render alley --size 32x32 --frames 2 --occlusion-culling -o a%d.png", "OcclusionCulling"},
        Swept{"render alley --size 32x32 --frames 2 --occlusion-culling --submission gpu-driven -o a%d.png",
              "DeviceOcclusion"},
        Swept{"render cubes --size 16x16 --submission primaries -o a.png", "Primaries"},
        Swept{"render cubes --size 16x16 --surface visibility -o a.png", "Visibility"},
        Swept{"render sheets --size 16x16 --translucency sorted -o a.png", "Sorted"},
        Swept{"render cubes --size 16x16 --targets layers --split count:3 --focus 12000:1 -o a.png", "Focus"},
        Swept{"render cubes --size 16x16 --shadows anchored -o a.png", "Shadows"},
        Swept{"render cubes --size 16x16 --antialias edges --occlusion 1 --fog 1e5 -o a.exr", "Effects"},
        Swept{"pictures --scenes cubes --techniques log --size 16x16 --frames 1 --out p --json p.json",
              "Pictures"},
        Swept{"flicker --frames 2 --size 16x16 --techniques cdr --state s --json f.json", "Flicker"},
        Swept{"timing --frames 1 --size 16x16 --modes log --in-flight 2 --csv t.csv", "Timing"},
        Swept{"probe --size 16x16 --techniques standard --formats d32f --distances 10 --json p.json",
              "Probe"},
        Swept{"translucency --size 16x16 --repeats 1 --cascades 2 --out t", "Translucency"},
        Swept{"render cubes --size 16x16 --stereo parallel --eye-distance 1 -o a.png", "Stereo"},
        Swept{"render cubes --size 16x16 --technique anchored --certify c.json -o a.png", "Certify"},
        Swept{"devices --json dev.json", "Devices"},
        Swept{"orbit --frames 1 --size 16x16 --techniques anchored --json o.json", "Orbit"},
        Swept{
            "scaling --draws 1 --threads 1 --cascades 1 --repeats 1 --size 16x16 --targets single --csv s.csv",
            "Scaling"},
        Swept{"detail cubes --frames 1 --size 16x16 --json d.json", "Detail"},
        Swept{
            "coplanar --frames 1 --search-views 1 --slopes 0 --constants 0,1 --size 16x16 --techniques reversed "
            "--json c.json",
            "Coplanar"},
        Swept{"shadows cubes --size 16x16 --json s.json", "ShadowsOfMaps"},
        Swept{"effects cubes --frames 1 --size 16x16 --techniques reversed --json e.json",
              "EffectsOfPresets"},
        Swept{"focus --frames 1 --cameras 2 --size 16x16 --json f.json", "FocusOfCameras"},
        Swept{"inspect cubes --frames 1 --size 16x16 --techniques standard --json i.json", "Inspect"},
        Swept{"models " CDR_SOURCE_DIR "/tests/assets/well.gltf --size 16x16 --json m.json", "Models"},
        Swept{"rivals cubes --frames 1 --distances 1 --size 16x16 --techniques anchored "
              "--rivals atomic-log --json r.json",
              "Rivals"},
        Swept{"advise --separation 1 --far 1000 --format d32f --techniques reversed --measured --size 16x16 "
              "--frames 1 --json a.json",
              "AdviseMeasured"},
        Swept{"report --smallest --sections precision -o r", "Report"}),
    [](const auto& row) { return std::string(row.param.name); });

} // namespace

} // namespace cdr::cli_test
