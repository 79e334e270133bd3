#include "../support/refusal.h"
#include "../support/shell.h"
#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <runs/unit_state.h>

#include <fstream>
#include <string>

namespace cdr::runs {
namespace {

const std::string kDigest(64, 'a');

std::string wholeText() {
    return stateHeadOf(kDigest) + stateLineOf(2, {{"value", 0.1}}) + stateLineOf(0, "zero");
}

std::string refusalOf(const std::string& text) {
    return test::inputErrorOf([&] { readUnitState(text, kDigest, "s"); });
}

TEST(UnitState, HoldsWhatWasKept) {
    const UnitState state = readUnitState(wholeText(), kDigest, "s");
    ASSERT_EQ(state.made.size(), 2u);
    EXPECT_EQ(state.made.at(2).at("value"), 0.1);
    EXPECT_EQ(state.made.at(0), "zero");
    EXPECT_EQ(state.bytes, wholeText().size());
    EXPECT_TRUE(readUnitState("", kDigest, "s").made.empty());
}

/// As a process that is killed leaves it. A head is written whole.
TEST(UnitState, DropsALastLineThatWasCutOff) {
    const std::string whole = wholeText();
    const std::size_t head = stateHeadOf(kDigest).size();
    const std::size_t first = head + stateLineOf(2, {{"value", 0.1}}).size();
    for (std::size_t size = head; size < whole.size(); ++size) {
        const UnitState state = readUnitState(whole.substr(0, size), kDigest, "s");
        EXPECT_EQ(state.made.size(), size < first ? 0u : 1u) << size;
        EXPECT_EQ(state.bytes, size < first ? head : first) << size;
    }
    for (std::size_t size = 1; size < head; ++size) {
        EXPECT_NE(refusalOf(whole.substr(0, size)), "") << size;
    }
}

TEST(UnitState, RefusesAnyByteThatIsAnother) {
    const std::string whole = wholeText();
    for (std::size_t i = 0; i + 1 < whole.size(); ++i) { // without the last line's end, that line was cut off
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 1);
        EXPECT_NE(refusalOf(damaged), "") << i;
    }
}

TEST(UnitState, SaysWhatIsWrong) {
    const std::string head = stateHeadOf(kDigest);
    const std::string end = "; remove it or name another file";
    EXPECT_EQ(refusalOf("{}"), "s: is no state" + end);
    EXPECT_EQ(refusalOf(stateHeadOf(std::string(64, 'b'))),
              "s: is the state of a run with other options or files, another version or device" + end);
    for (const std::string text :
         {"", "{\"unit\":-1,\"made\":1}", "{", "[]", "{\"unit\":0}", "{\"unit\":0,\"made\":1}}"}) {
        EXPECT_EQ(refusalOf(head + summed(text)), "s: is damaged" + end) << text;
    }
    EXPECT_EQ(refusalOf(head + "\n"), "s: is damaged" + end);
    const std::string deep(100'000, '[');
    EXPECT_EQ(refusalOf(head + summed("{\"unit\":0,\"made\":" + deep + std::string(deep.size(), ']') + "}")),
              "s: is damaged" + end);
}

TEST(UnitStateFile, GoesOnBehindWhatIsWhole) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "s";
    {
        UnitStateFile file(path, kDigest);
        EXPECT_FALSE(std::filesystem::exists(path)) << "nothing was kept yet";
        file.keep(2, {{"value", 0.1}});
    }
    std::ofstream(path, std::ios::app) << "cut off";
    {
        UnitStateFile file(path, kDigest);
        EXPECT_EQ(file.made().size(), 1u);
        file.keep(0, "zero");
        EXPECT_EQ(test::readText(path), wholeText());
    }
    platform::writeText(path, "");
    UnitStateFile(path, kDigest).keep(1, 1);
    EXPECT_EQ(test::readText(path), stateHeadOf(kDigest) + stateLineOf(1, 1));
}

/// A result that is kept again, since what it stands for was lost, replaces the one before.
TEST(UnitStateFile, TakesTheLastOfAUnit) {
    const UnitState state = readUnitState(wholeText() + stateLineOf(2, 7), kDigest, "s");
    EXPECT_EQ(state.made.at(2), 7);
    EXPECT_EQ(state.made.size(), 2u);
}

TEST(UnitStateFile, RefusesWhatCannotBeWritten) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(UnitStateFile(folder.path() / "missing/s", kDigest), base::InputError);
    EXPECT_THROW(UnitStateFile(folder.path(), kDigest), base::InputError);
    EXPECT_THROW(UnitStateFile("/dev/full", kDigest), base::InputError);
}

} // namespace
} // namespace cdr::runs
