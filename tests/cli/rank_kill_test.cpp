#include "rank_test.h"

#include <cdr/platform/file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace cdr::cli_test {
namespace {

namespace fs = std::filesystem;

/// A run over ranks, or of one process, whose processes say their numbers in files pid.RANK, or pid.
class RankKills : public RankTest {
  protected:
    /// @param ranks 0 for one process that no launcher starts.
    /// @param signalling as the function of that name says; empty for a run that is left alone.
    ProgramResult run(unsigned ranks, const std::string& arguments,
                      const std::string& signalling = "") const {
        const ProgramResult result = RankTest::run(
            arguments, signalling + test::launched(CDR_MPIEXEC, static_cast<int>(ranks)) +
                           " sh -c 'echo $$ >pid.$OMPI_COMM_WORLD_RANK$PMI_RANK; exec \"$@\"' sh");
        if (!signalling.empty()) { // the process that signals must end before the next run
            platform::writeText(at("over"), "");
            while (!fs::exists(at("signalled"))) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        }
        for (const char* name :
             {"pid.", "pid.0", "pid.1", "pid.2", "pid.3", "over", "signalled", "kill.err"}) {
            fs::remove(at(name));
        }
        return result;
    }

    /// For a shell: waits until a condition of the shell's holds, and then some time. Then it sends a signal, unless the run is
    /// over.
    static std::string signalling(const std::string& signal, const std::string& victim,
                                  const std::string& condition, double seconds) {
        return "{ { until " + condition + " || [ -e over ]; do sleep 0.02; done; sleep " +
               std::to_string(seconds) + "; [ -e over ] || kill -" + signal + " $(cat " + victim +
               "); echo >signalled; } 2>kill.err & } && ";
    }
};

/// The lines that begin as the program's own; MPI and its launcher may add some.
std::vector<std::string> ownLinesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("cdr: ")) {
            lines.push_back(line);
        }
    }
    return lines;
}

/// MPICH's launcher kills all ranks when it sees one gone, so a busy machine may leave no time to say who it was.
bool killsAllAtOnce() {
    return std::string(CDR_MPIEXEC).find("mpich") != std::string::npos;
}

/// Whichever it is, and whether or not something is kept.
TEST_F(RankKills, ARankThatIsKilledIsNamedInOneLine) {
    for (int rank = 0; rank < 4; ++rank) {
        const bool keeps = rank % 2 == 0;
        const ProgramResult result =
            run(4,
                std::string("render afc --frames 100000 --size 64x36 -o f%d.png --json a.json") +
                    (keeps ? " --state s" : ""),
                signalling("KILL", "pid." + std::to_string(rank), "[ -e f2.png ]", 0.05 * rank));
        EXPECT_NE(result.status, 0);
        const std::vector<std::string> lines = ownLinesOf(result.err);
        EXPECT_FALSE(fs::exists(at("a.json")));
        fs::remove(at("f2.png"));
        if (killsAllAtOnce() && lines.empty()) {
            continue;
        }
        ASSERT_EQ(lines.size(), 1u) << rank << ": " << result.err;
        EXPECT_TRUE(std::regex_match(
            lines.front(), std::regex("cdr: rank " + std::to_string(rank) + " of 4 on .+ was killed" +
                                      (keeps ? "; what was finished stays in s" : ""))))
            << lines.front();
    }
}

/// The launcher asks the others to end then, and they say nothing.
TEST_F(RankKills, ASignalThatARankIsSentIsNamedInOneLine) {
    for (const std::string signal : {"TERM", "HUP", "INT"}) {
        const ProgramResult result = run(3, "render afc --frames 100000 --size 64x36 -o f%d.png",
                                         signalling(signal, "pid.1", "[ -e f2.png ]", 0.05));
        EXPECT_NE(result.status, 0);
        const std::vector<std::string> lines = ownLinesOf(result.err);
        ASSERT_EQ(lines.size(), 1u) << signal << ": " << result.err;
        EXPECT_TRUE(std::regex_match(lines.front(),
                                     std::regex("cdr: rank 1 of 3 on .+ was asked to end by SIG" + signal)))
            << lines.front();
        fs::remove(at("f2.png"));
    }
}

/// Starts a run again and again. In each start some rank is killed at some moment after the state grew. Each start has other
/// ranks.
class KilledAgainAndAgain : public RankKills {
  protected:
    /// @param afterEach is told how each start ended.
    void killOften(const std::string& arguments, int kills,
                   const std::function<void(const ProgramResult& result)>& afterEach) {
        std::mt19937 random(2013);
        int killed = 0;
        for (int attempt = 0; attempt < 10 * kills && killed < kills; ++attempt) {
            const auto ranks = static_cast<unsigned>(random() % 5);
            const std::string victim = ranks == 0 ? "pid." : "pid." + std::to_string(random() % ranks);
            fs::remove(at("before"));
            if (fs::exists(at("state"))) {
                fs::copy_file(at("state"), at("before"));
            }
            const ProgramResult result =
                run(ranks, arguments,
                    signalling("KILL", victim, "{ [ -e state ] && ! cmp -s state before; }",
                               0.01 * static_cast<double>(random() % 10)));
            killed += result.status != 0 ? 1 : 0;
            afterEach(result);
        }
        fs::remove(at("before"));
        std::printf("%d runs were killed\n", killed);
        EXPECT_EQ(killed, kills);
    }

    static int kills() { return takesAllCases() ? 50 : 3; }
};

TEST_F(KilledAgainAndAgain, AFlickerRunThatIsKilledEndsAsOneThatIsNot) {
    const std::string arguments =
        "flicker --frames " + std::string(takesAllCases() ? "900" : "100") +
        " --size 96x54 --near-object --techniques anchored --fitted-range --format d16 "
        "--flip-every 4 --json all.json --state state";
    const TemporaryFolder whole;
    ASSERT_EQ(runProgram(arguments, whole.path()).status, 0);
    const std::string wanted = readText(whole.path() / "all.json");
    killOften(arguments, kills(), [&](const ProgramResult& result) {
        if (result.status == 0) { // before the kill: the next run starts again
            EXPECT_EQ(textIn("all.json"), wanted);
            fs::remove(at("state"));
        }
    });
    const ProgramResult last = run(3, arguments);
    EXPECT_EQ(last.status, 0) << last.err;
    EXPECT_EQ(textIn("all.json"), wanted);
    EXPECT_EQ(textIn("state"), readText(whole.path() / "state"));
}

/// When each picture was written, by name.
std::map<std::string, fs::file_time_type> picturesIn(const fs::path& folder) {
    std::map<std::string, fs::file_time_type> pictures;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".png" && !entry.path().filename().string().starts_with('.')) {
            pictures[entry.path().filename().string()] = entry.last_write_time();
        }
    }
    return pictures;
}

/// How many frames a state keeps: its whole lines, without the first.
std::size_t keptIn(const fs::path& state) {
    const std::string text = readText(state);
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    return lines == 0 ? 0 : lines - 1;
}

class KilledRender : public KilledAgainAndAgain {
  protected:
    /// Pictures of which none is written again that was kept.
    void expectGoesOn(const std::string& arguments, std::size_t frames, int times) {
        const TemporaryFolder whole;
        ASSERT_EQ(runProgram(arguments, whole.path()).status, 0);
        std::size_t keptBefore = 0;
        std::map<std::string, fs::file_time_type> picturesBefore;
        const auto expectOnlyMissing = [&](const ProgramResult& result) {
            const auto pictures = picturesIn(folder());
            std::size_t drawn = 0;
            for (const auto& [name, time] : pictures) {
                drawn += picturesBefore.contains(name) && picturesBefore.at(name) == time ? 0 : 1;
            }
            // A picture is written before the state says so.
            const std::size_t kept = keptIn(at("state"));
            EXPECT_GE(drawn, kept - keptBefore);
            EXPECT_LE(drawn, kept - keptBefore + (result.status == 0 ? 0 : 1));
            if (result.status == 0) { // one that is killed may keep what it printed
                EXPECT_EQ(result.out.find(std::to_string(keptBefore) + " of " + std::to_string(frames) +
                                          " frames are kept in state\n") != std::string::npos,
                          keptBefore > 0)
                    << result.out;
            }
            keptBefore = kept;
            picturesBefore = pictures;
        };
        killOften(arguments, times, [&](const ProgramResult& result) {
            expectOnlyMissing(result);
            if (result.status == 0) { // before the kill: the next run starts again
                fs::remove(at("state"));
                keptBefore = 0;
            }
        });
        const ProgramResult last = run(3, arguments);
        EXPECT_EQ(last.status, 0) << last.err;
        expectOnlyMissing(last);
        EXPECT_EQ(keptIn(at("state")), frames);
        expectSamePictures(whole);
    }

  private:
    /// The state has times in it, and a process that was killed leaves what it was writing.
    void expectSamePictures(const TemporaryFolder& whole) const {
        const auto visible = [](const fs::path& in) {
            auto files = filesIn(in);
            std::erase_if(
                files, [](const auto& file) { return file.first == "state" || file.first.starts_with('.'); });
            return files;
        };
        const auto expected = visible(whole.path());
        const auto files = visible(folder());
        ASSERT_EQ(files.size(), expected.size());
        for (const auto& [name, text] : expected) {
            EXPECT_TRUE(files.contains(name) && files.at(name) == text) << name;
        }
    }
};

/// A fitted split keeps to the frames before, those that are kept among them, and 16 bits of depth show where it cut.
TEST_F(KilledRender, AKilledRenderGoesOnWithItsFrames) {
    const std::string frames = takesAllCases() ? "900" : "100";
    expectGoesOn(
        "render afc-near --depth standard --split fitted:1,max=2 --format d16 --size 96x54 --frames " +
            frames + " -o f%03d.png --json all.json --state state",
        std::stoul(frames), kills());
}

TEST_F(KilledRender, AKilledRenderGoesOnWithItsCascades) {
    const std::string frames = takesAllCases() ? "400" : "100";
    expectGoesOn("render afc-near --technique cdr --ranks cascades --size 96x54 --frames " + frames +
                     " -o f%03d.png --json all.json --state state",
                 std::stoul(frames), takesAllCases() ? 20 : 3);
}

} // namespace
} // namespace cdr::cli_test
