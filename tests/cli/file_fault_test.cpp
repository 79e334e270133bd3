#include "at_once.h"
#include "program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <iterator>
#include <map>
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

/// A command that writes.
struct Writer {
    const char* command;
    const char* name;
    /// Of its calls each so many-th fails, with another error at each; with CDR_ALL_CASES each with each error. It has no factor 2
    /// or 3: many files take 3 or 4 calls.
    long stride = 1;

    friend std::ostream& operator<<(std::ostream& out, const Writer& writer) { return out << writer.command; }
};

class FileFaults : public testing::TestWithParam<Writer> {
  protected:
    /// A run of which a call fails, and its folder.
    struct Run {
        std::unique_ptr<TemporaryFolder> folder = std::make_unique<TemporaryFolder>();
        long after = kNever; ///< calls that succeed before
        int error = ENOSPC;
        ProgramResult result{};
        long calls = 0; ///< that it made, in the process with most
    };
    static constexpr long kNever = 1'000'000'000;

    static void run(Run& run) {
        const std::filesystem::path log = run.folder->path().string() + ".calls";
        run.result = runProgram(GetParam().command, run.folder->path(),
                                fmt::format("CDR_FILE_FAULT='{} {}' CDR_FILE_FAULT_LOG='{}' {} timeout 1000",
                                            run.after, run.error, log.string(), preloading(CDR_FILE_FAULTS)));
        std::istringstream counts(readText(log));
        for (long calls = 0; counts >> calls;) {
            run.calls = std::max(run.calls, calls);
        }
        std::filesystem::remove(log);
    }

    /// One line and a status, or all as where no call fails.
    void expectEnded(const Run& run) {
        SCOPED_TRACE(testing::Message() << GetParam().command << ": call " << run.after << ", " << run.error);
        const ProgramResult& result = run.result;
        // A report that cannot be finished keeps what was measured, and says where.
        expectWholeFiles(*run.folder, result.err.find("what was measured is in") != std::string::npos);
        if (result.status == 0) {
            EXPECT_EQ(result.err, "");
            EXPECT_EQ(sizesIn(*run.folder), m_sizes);
            return;
        }
        for (const auto& [name, size] : sizesIn(*run.folder)) {
            EXPECT_TRUE(size == 0 || (m_sizes.contains(name) && size == m_sizes.at(name)))
                << name << ": " << size;
        }
        ++m_failures;
        // Without permission or without its folder, a file may be refused as input is.
        EXPECT_TRUE(result.status == 1 || (result.status == 2 && run.error != ENOSPC && run.error != EIO))
            << result.status << ": " << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }

    /// Names of files. Sizes of pictures and videos in formats that expectWholeFiles() does not read.
    static std::map<std::string, std::uintmax_t> sizesIn(const TemporaryFolder& folder) {
        std::map<std::string, std::uintmax_t> sizes;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
            const std::string extension = entry.path().extension();
            const bool isUnread = extension == ".tga" || extension == ".exr" || extension == ".mp4";
            sizes[std::filesystem::relative(entry.path(), folder.path())] = isUnread ? entry.file_size() : 0;
        }
        return sizes;
    }

    std::map<std::string, std::uintmax_t> m_sizes; ///< of what a run writes whose calls all succeed
    std::size_t m_failures = 0;
};

/// One call on a file fails, whichever: one line that says so, its exit status, and what there is is whole.
TEST_P(FileFaults, EveryWriteMayFail) {
    if (std::string(CDR_FILE_FAULTS).empty()) {
        GTEST_SKIP() << "sanitizers stand where the library that makes calls fail would";
    }
    Run sound;
    run(sound);
    const auto says = [&](const char* text) { return sound.result.err.find(text) != std::string::npos; };
    if (sound.result.status == 2 && (says("tools/setup.sh") || says("gnuplot") || says("ffmpeg"))) {
        GTEST_SKIP() << sound.result.err; // a checkout or a machine without it
    }
    ASSERT_EQ(sound.result.status, 0) << sound.result.err;
    ASSERT_GT(sound.calls, 0);
    m_sizes = sizesIn(*sound.folder);
    constexpr std::array<int, 4> kErrors{ENOSPC, EACCES, EIO, ENOENT};
    std::vector<Run> runs;
    for (long after = 0; after < sound.calls; after += takesAllCases() ? 1 : GetParam().stride) {
        for (std::size_t error = 0; error < kErrors.size(); ++error) {
            // One step more after each four, so that calls of one kind meet all errors.
            const std::size_t turn = static_cast<std::size_t>(after / GetParam().stride);
            if (takesAllCases() || error == (turn + turn / 4) % kErrors.size()) {
                runs.push_back({.after = after, .error = kErrors.at(error)});
            }
        }
    }
    for (std::size_t first = 0; first < runs.size(); first += programsAtOnce()) {
        const std::size_t count = std::min(programsAtOnce(), runs.size() - first);
        runAtOnce(count, [&](std::size_t i) { run(runs[first + i]); });
        for (std::size_t i = first; i < first + count; ++i) {
            expectEnded(runs[i]);
            runs[i].folder.reset();
        }
    }
    EXPECT_GT(m_failures, 0u);
    std::printf("%zu cases, %zu failed\n", runs.size(), m_failures);
}

const Writer kWriters[]{
    {"render cubes --size 16x16 --quiet -o a.png --json a.json --trace t.json", "Render"},
    {"render cubes --size 16x16 --quiet --aov distance -o a.exr", "Exr"},
    {"render cubes --size 16x16 --quiet --frames 2 -o a%d.tga", "Tga", 5},
    {"render cubes --size 16x16 --quiet --frames 3 -o a%d.png --state s", "State", 5},
    {"probe --quiet --distances 10,100 --techniques log --formats d32f --size 16x16 --state s --json p.json",
     "Probe", 5},
    {"precision --quiet --curve c.csv --json p.json", "Precision", 5},
    {"pictures --quiet --scenes cubes --techniques log --size 16x16 --frames 1 --out p --json p.json",
     "Pictures", 5},
    {"flicker --quiet --frames 2 --size 16x16 --techniques cdr --state s --tga t --json f.json", "Flicker",
     5},
    {"flicker --quiet --frames 2 --size 16x16 --techniques cdr,log --videos v", "Videos", 7},
    {"timing --quiet --frames 1 --size 16x16 --modes log --csv t.csv --trace t.json --json j.json", "Timing",
     5},
    {"timing --quiet --frames 1 --size 16x16 --modes log --plot t.svg", "TimingPlot", 5},
    {"render cubes --size 16x16 --quiet --technique anchored -o a.png --certify c.json", "Certify", 5},
    {"inspect cubes --quiet --frames 1 --size 16x16 --techniques standard --heat-map h.png --json i.json",
     "HeatMap", 5},
    {"orbit --quiet --frames 1 --size 16x16 --techniques anchored --plot p.png", "Plot", 7},
    {"orbit --quiet --frames 1 --size 16x16 --techniques anchored --out o --state s --json o.json", "Orbit",
     11},
    {"models " CDR_SOURCE_DIR "/tests/assets/well.gltf --quiet --size 16x16 --out o --json m.json", "Models",
     5},
    {"shadows cubes --quiet --size 16x16 --out o --json s.json", "Shadows", 5},
    {"translucency --quiet --size 16x16 --repeats 1 --cascades 2 --out o --state s --json t.json",
     "Translucency", 11},
    {"coplanar --quiet --frames 1 --search-views 1 --size 16x16 --techniques reversed --out o --state s "
     "--json c.json",
     "Coplanar", 17},
    {"rivals cubes --quiet --frames 1 --distances 1 --size 16x16 --techniques anchored --rivals atomic-log "
     "--json r.json",
     "Rivals", 5},
    {"detail cubes --quiet --frames 1 --size 16x16 --out o --state s --json d.json", "Detail", 11},
    {"effects --quiet --frames 1 --size 16x16 --out o --json e.json", "Effects", 17},
    {"focus --quiet --frames 1 --cameras 2 --size 16x16 --out o --json f.json", "Focus", 7},
    {"scaling --quiet --draws 1 --threads 1 --cascades 1 --repeats 1 --size 16x16 --targets single --csv s.csv "
     "--plot s.png --json s.json",
     "Scaling", 7},
    {"devices --quiet --json d.json", "Devices"},
    {"advise --quiet --separation 1 --json a.json", "Advise"},
    {"report --quiet --smallest --sections precision -o r --state s --json j.json", "Report", 17}};

INSTANTIATE_TEST_SUITE_P(Commands, FileFaults, testing::ValuesIn(kWriters),
                         [](const auto& row) { return std::string(row.param.name); });

/// Options that take a text or a file and write none. One that is new must stand here or in a Writer's command.
const std::set<std::string> kWriteNothing{
    "--against",    "--animation",   "--antialias",    "--aov",    "--batching",  "--colours",
    "--data",       "--deform",      "--depth",        "--detail", "--device",    "--direction",
    "--eye",        "--focus",       "--fog",          "--format", "--formats",   "--layer",
    "--light",      "--methods",     "--model",        "--modes",  "--occlusion", "--lens-shift",
    "--path",       "--ranks",       "--rivals",       "--scene",  "--scenes",    "--sections",
    "--shadows",    "--size",        "--snapping",     "--split",  "--stereo",    "--stereo-picture",
    "--submission", "--submissions", "--surface",      "--target", "--targets",   "--technique",
    "--techniques", "--tone-map",    "--translucency", "--unit",   "--up",        "--views"};

/// "-o,--output" of each option of a command that takes a text or a file, as its help has them.
std::vector<std::string> textOptionsOf(const std::string& command) {
    const TemporaryFolder folder;
    std::istringstream help(runProgram(command + " --help", folder.path()).out);
    std::vector<std::string> options;
    for (std::string line; std::getline(help, line);) {
        std::smatch found;
        if (std::regex_search(line, found, std::regex("^  (-[^ ]+) \\[?(?!UINT|INT|FLOAT)[A-Z]"))) {
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

/// Random moments of runs of a command, in seconds, that follow a machine which becomes slower or faster.
class Moments {
  public:
    /// From a run that nothing happens to.
    Moments(const std::string& command, const TemporaryFolder& folder, unsigned seed) : m_random(seed) {
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_EQ(runProgram(command, folder.path()).status, 0);
        m_latest = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    double next() { return std::uniform_real_distribution<>(0.1 * m_latest, m_latest)(m_random); }

    /// What became of a run that began with nothing.
    void follow(bool isInterrupted, bool hasWritten) {
        if (!isInterrupted) {
            m_latest *= 0.8;
        } else if (!hasWritten) {
            m_latest *= 1.25;
        }
    }

  private:
    std::mt19937 m_random;
    double m_latest = 1.0;
};

constexpr const char* kSignals[]{"INT", "TERM", "KILL"};

/// Whether to interrupt once more: as often as asked for, then until something was written before, which a slow machine may
/// need tries for.
bool goesOn(int run, int found) {
    return run < (takesAllCases() ? 200 : 3) || (found == 0 && run < 100);
}

/// Interrupted at random moments, a run goes on to the results of one that was not.
TEST(Signals, ARunThatIsInterruptedEndsAsOneThatIsNot) {
    const std::string command =
        "flicker --quiet --frames 12 --size 64x36 --techniques cdr,log --state s --json f.json";
    const TemporaryFolder whole;
    Moments moments(command, whole, 17);
    const nlohmann::json wanted = nlohmann::json::parse(readText(whole.path() / "f.json")).at("results");
    int interrupted = 0;
    int goneOn = 0;
    for (int i = 0; goesOn(i, goneOn); ++i) {
        const TemporaryFolder folder;
        const std::string signal = kSignals[i % 3];
        ProgramResult result;
        bool isKept = false;
        for (int attempt = 0; attempt < 3; ++attempt) {
            result = runProgram(command, folder.path(),
                                "timeout --signal=" + signal + " " + std::to_string(moments.next()));
            const bool isInterrupted = result.status != 0;
            const bool isFirst = !isKept;
            isKept = std::filesystem::exists(folder.path() / "s");
            if (isFirst) {
                moments.follow(isInterrupted, isKept);
            }
            interrupted += isInterrupted ? 1 : 0;
            goneOn += isInterrupted && isKept ? 1 : 0;
            expectWholeFiles(folder, signal == "KILL");
        }
        result = runProgram(command, folder.path());
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(nlohmann::json::parse(readText(folder.path() / "f.json")).at("results"), wanted) << signal;
    }
    EXPECT_GT(goneOn, 0);
    std::printf("%d interruptions, %d of them with frames kept\n", interrupted, goneOn);
}

/// The same moments while pictures are written: each that is there is whole.
TEST(Signals, PicturesOfARunThatIsInterruptedAreWhole) {
    const std::string command = "render cubes --size 320x180 --frames 100 --quiet -o a%d.png";
    Moments moments(command, TemporaryFolder(), 18);
    int withPictures = 0;
    for (int i = 0; goesOn(i, withPictures); ++i) {
        const TemporaryFolder folder;
        const std::string signal = kSignals[i % 3];
        const ProgramResult result = runProgram(
            command, folder.path(), "timeout --signal=" + signal + " " + std::to_string(moments.next()));
        expectWholeFiles(folder, signal == "KILL");
        const bool isInterrupted = result.status != 0;
        const std::filesystem::directory_iterator files(folder.path());
        const bool hasPicture = std::any_of(begin(files), end(files), [](const auto& entry) {
            return entry.path().filename().string().front() != '.';
        });
        moments.follow(isInterrupted, hasPicture);
        withPictures += isInterrupted && hasPicture ? 1 : 0;
    }
    EXPECT_GT(withPictures, 0);
}

} // namespace

} // namespace cdr::cli_test
