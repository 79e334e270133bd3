#include "at_once.h"
#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <memory>
#include <ostream>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace cdr::cli_test {

namespace {

/// Files that can be read, and hidden ones only where they may stay.
void expectWholeFiles(const TemporaryFolder& folder, bool mayHide = false) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
        const std::string name = entry.path().filename().string();
        if (name.front() == '.') {
            EXPECT_TRUE(mayHide) << name;
            continue;
        }
        if (entry.path().extension() == ".png") {
            EXPECT_NO_THROW(readPicture(entry.path())) << name;
        } else if (entry.path().extension() == ".json") {
            EXPECT_TRUE(nlohmann::json::accept(readText(entry.path()))) << name;
        } else if (entry.is_regular_file()) {
            EXPECT_GT(entry.file_size(), 0u) << name;
        }
    }
}

/// A command that writes.
struct Writer {
    const char* command;
    const char* name;
    long stride = 4; ///< of its calls, each so many-th fails; with CDR_ALL_CASES each

    friend std::ostream& operator<<(std::ostream& out, const Writer& writer) { return out << writer.command; }
};

class FileFaults : public testing::TestWithParam<Writer> {};

/// A run of which a call fails, and its folder.
struct Failing {
    std::unique_ptr<TemporaryFolder> folder = std::make_unique<TemporaryFolder>();
    ProgramResult result;
};

/// One line and a status, or nothing said where no call failed.
void expectEnded(const Failing& failing, int error) {
    const ProgramResult& result = failing.result;
    // A report that cannot be finished keeps what was measured, and says where.
    expectWholeFiles(*failing.folder, result.err.find("what was measured is in") != std::string::npos);
    if (result.status == 0) {
        EXPECT_EQ(result.err, "");
        return;
    }
    // Without permission or without its folder, a file may be refused as input is.
    EXPECT_TRUE(result.status == 1 || (result.status == 2 && error != ENOSPC && error != EIO))
        << result.status << ": " << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

/// One call on a file fails, whichever: one line that says so, its exit status, and what there is is whole.
TEST_P(FileFaults, EveryWriteMayFail) {
    if (std::string(CDR_FILE_FAULTS).empty()) {
        GTEST_SKIP() << "sanitizers stand where the library that makes calls fail would";
    }
    const auto run = [&](long after, int error, const TemporaryFolder& folder) {
        return runProgram(GetParam().command, folder.path(),
                          "CDR_FILE_FAULT='" + std::to_string(after) + " " + std::to_string(error) +
                              "' LD_PRELOAD='" CDR_FILE_FAULTS "' timeout 1000");
    };
    constexpr long kNever = 1'000'000'000;
    const TemporaryFolder sound;
    const ProgramResult served = run(kNever, ENOSPC, sound);
    const auto says = [&](const char* text) { return served.err.find(text) != std::string::npos; };
    if (served.status == 2 && (says("tools/setup.sh") || says("gnuplot") || says("ffmpeg"))) {
        GTEST_SKIP() << served.err; // a checkout or a machine without it
    }
    ASSERT_EQ(served.status, 0) << served.err;
    constexpr long kMaxCalls = 2000;
    std::size_t cases = 0;
    std::size_t failures = 0;
    for (const int error : {ENOSPC, EACCES, EIO, ENOENT}) {
        const long stride = takesAllCases() ? 1 : GetParam().stride;
        bool isOver = false; // more calls than there are
        for (long first = error % stride; first < kMaxCalls && !isOver;) {
            std::vector<Failing> failing(programsAtOnce());
            runAtOnce(failing.size(), [&](std::size_t i) {
                failing[i].result = run(first + static_cast<long>(i) * stride, error, *failing[i].folder);
            });
            for (const Failing& each : failing) {
                SCOPED_TRACE(testing::Message() << GetParam().command << ": call " << first << ", " << error);
                expectEnded(each, error);
                ++cases;
                first += stride;
                isOver = each.result.status == 0;
                if (isOver) {
                    break;
                }
                ++failures;
            }
        }
    }
    EXPECT_GT(failures, 0u);
    std::printf("%zu cases\n", cases);
}

const Writer kWriters[]{
    {"render cubes --size 16x16 --quiet -o a.png --json a.json --trace t.json", "Render"},
    {"render cubes --size 16x16 --quiet --aov distance -o a.exr", "Exr"},
    {"render cubes --size 16x16 --quiet --frames 2 -o a%d.tga", "Tga"},
    {"render cubes --size 16x16 --quiet --frames 3 -o a%d.png --state s", "State"},
    {"probe --quiet --distances 10,100 --techniques log --formats d32f --size 16x16 --state s --json p.json",
     "Probe"},
    {"precision --quiet --curve c.csv --json p.json", "Precision"},
    {"pictures --quiet --scenes cubes --techniques log --size 16x16 --frames 1 --out p --json p.json",
     "Pictures"},
    {"flicker --quiet --frames 2 --size 16x16 --techniques cdr --state s.json --tga t --json f.json",
     "Flicker"},
    {"flicker --quiet --frames 2 --size 16x16 --techniques cdr,log --videos v", "Videos", 16},
    {"timing --quiet --frames 1 --size 16x16 --modes log --csv t.csv --trace t.json --json j.json", "Timing"},
    {"timing --quiet --frames 1 --size 16x16 --modes log --plot t.svg", "TimingPlot", 8},
    {"render cubes --size 16x16 --quiet --technique anchored -o a.png --certify c.json", "Certify"},
    {"inspect cubes --quiet --frames 1 --size 16x16 --techniques standard --heat-map h.png --json i.json",
     "HeatMap"},
    {"orbit --quiet --frames 1 --size 16x16 --techniques anchored --plot p.png", "Plot", 8},
    {"orbit --quiet --frames 1 --size 16x16 --techniques anchored --out o --state s --json o.json", "Orbit",
     16},
    {"models " CDR_SOURCE_DIR "/tests/assets/well.gltf --quiet --size 16x16 --out o --json m.json", "Models"},
    {"shadows cubes --quiet --size 16x16 --out o --json s.json", "Shadows"},
    {"translucency --quiet --size 16x16 --repeats 1 --cascades 2 --out o --state s --json t.json",
     "Translucency"},
    {"coplanar --quiet --frames 1 --search-views 1 --size 16x16 --techniques reversed --out o --state s "
     "--json c.json",
     "Coplanar", 16},
    {"rivals cubes --quiet --frames 1 --distances 1 --size 16x16 --techniques anchored --rivals atomic-log "
     "--json r.json",
     "Rivals"},
    {"detail cubes --quiet --frames 1 --size 16x16 --out o --state s --json d.json", "Detail", 8},
    {"effects --quiet --frames 1 --size 16x16 --out o --json e.json", "Effects", 16},
    {"focus --quiet --frames 1 --cameras 2 --size 16x16 --out o --json f.json", "Focus", 8},
    {"scaling --quiet --draws 1 --threads 1 --cascades 1 --repeats 1 --size 16x16 --targets single --csv s.csv "
     "--plot s.png --json s.json",
     "Scaling", 8},
    {"devices --quiet --json d.json", "Devices"},
    {"advise --quiet --separation 1 --json a.json", "Advise"},
    {"report --quiet --smallest --sections precision -o r --state s --json j.json", "Report", 16}};

INSTANTIATE_TEST_SUITE_P(Commands, FileFaults, testing::ValuesIn(kWriters),
                         [](const auto& row) { return std::string(row.param.name); });

/// Options that take a text or a file and write none. One that is new must stand here or in a Writer's command.
const std::set<std::string> kWriteNothing{
    "--against",     "--animation",    "--antialias", "--aov",       "--batching",       "--colours",
    "--data",        "--depth",        "--detail",    "--device",    "--direction",      "--eye",
    "--focus",       "--fog",          "--format",    "--formats",   "--layer",          "--light",
    "--methods",     "--model",        "--modes",     "--occlusion", "--lens-shift",     "--path",
    "--ranks",       "--rivals",       "--scene",     "--scenes",    "--sections",       "--shadows",
    "--size",        "--snapping",     "--split",     "--stereo",    "--stereo-picture", "--submission",
    "--submissions", "--surface",      "--target",    "--targets",   "--technique",      "--techniques",
    "--tone-map",    "--translucency", "--unit",      "--up",        "--views"};

/// "-o,--output" of each option of a command that takes a text or a file, as its help has them.
std::vector<std::string> textOptionsOf(const std::string& command) {
    const TemporaryFolder folder;
    std::istringstream help(runProgram(command + " --help", folder.path()).out);
    std::vector<std::string> options;
    for (std::string line; std::getline(help, line);) {
        std::smatch found;
        if (std::regex_search(line, found, std::regex("^  (-[^ ]+) \\[?(TEXT|FILE)\\b"))) {
            options.push_back(found[1]);
        }
    }
    return options;
}

/// Whether a Writer of the command has the option, by one of its names.
bool isWritten(const std::string& command, const std::string& names) {
    const std::regex option(" (" + std::regex_replace(names, std::regex(","), "|") + ")( |$)");
    return std::any_of(std::begin(kWriters), std::end(kWriters), [&](const Writer& writer) {
        const std::string words = writer.command;
        return words.starts_with(command + " ") && std::regex_search(words, option);
    });
}

TEST(FileFaultList, HoldsEveryOptionThatWrites) {
    std::size_t written = 0;
    for (const std::string& command : commandNames()) {
        if (command == "view") {
            continue; // it starts the viewer, whose tests these are
        }
        for (const std::string& names : textOptionsOf(command)) {
            if (!kWriteNothing.contains(names.substr(names.rfind(',') + 1))) {
                EXPECT_TRUE(isWritten(command, names)) << command << " " << names;
                ++written;
            }
        }
    }
    EXPECT_GE(written, 45u); // else help is not what it was
}

/// Interrupted at random moments, a run goes on to the results of one that was not.
TEST(Signals, ARunThatIsInterruptedEndsAsOneThatIsNot) {
    const std::string command =
        "flicker --quiet --frames 12 --size 64x36 --techniques cdr,log --state s.json --json f.json";
    const TemporaryFolder whole;
    ASSERT_EQ(runProgram(command, whole.path()).status, 0);
    const nlohmann::json wanted = nlohmann::json::parse(readText(whole.path() / "f.json")).at("results");
    std::mt19937 random(17);
    std::uniform_real_distribution<> seconds(0.02, 0.4);
    const int runs = takesAllCases() ? 200 : 3;
    const char* const signals[]{"INT", "TERM", "KILL"};
    int interrupted = 0;
    for (int i = 0; i < runs; ++i) {
        const TemporaryFolder folder;
        const std::string signal = signals[i % 3];
        ProgramResult result;
        for (int attempt = 0; attempt < 3; ++attempt) {
            result = runProgram(command, folder.path(),
                                "timeout --signal=" + signal + " " + std::to_string(seconds(random)));
            interrupted += result.status != 0 ? 1 : 0;
            expectWholeFiles(folder, signal == "KILL");
        }
        result = runProgram(command, folder.path());
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(nlohmann::json::parse(readText(folder.path() / "f.json")).at("results"), wanted) << signal;
    }
    EXPECT_GT(interrupted, 0);
    std::printf("%d interruptions\n", interrupted);
}

/// The same moments while pictures are written: each that is there is whole.
TEST(Signals, PicturesOfARunThatIsInterruptedAreWhole) {
    std::mt19937 random(18);
    std::uniform_real_distribution<> seconds(0.05, 0.6);
    const int runs = takesAllCases() ? 200 : 3;
    const char* const signals[]{"INT", "TERM", "KILL"};
    for (int i = 0; i < runs; ++i) {
        const TemporaryFolder folder;
        const std::string signal = signals[i % 3];
        runProgram("render cubes --size 320x180 --frames 100 --quiet -o a%d.png", folder.path(),
                   "timeout --signal=" + signal + " " + std::to_string(seconds(random)));
        expectWholeFiles(folder, signal == "KILL");
    }
}

} // namespace

} // namespace cdr::cli_test
