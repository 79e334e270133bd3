#include "../support/fault.h"
#include "program.h"

#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cdr::cli_test {
namespace {

namespace fs = std::filesystem;

/// A run that keeps its frames, and what it has left.
class RenderState : public FolderTest {
  protected:
    static constexpr const char* kRender =
        "render afc-near --depth standard --split fitted:1,max=2 --format d16 --size 96x54 --frame 3 --frames 5 "
        "-o f%d.png --state s ";

    auto files() const { return filesIn(folder()); }

    /// The pictures that an action writes.
    template <typename Action>
    std::set<std::string> writtenBy(const Action& action) const {
        std::map<std::string, fs::file_time_type> before;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder())) {
            before[entry.path().filename().string()] = entry.last_write_time();
        }
        action();
        std::set<std::string> written;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder())) {
            const std::string name = entry.path().filename().string();
            if (entry.path().extension() == ".png" &&
                !(before.contains(name) && before.at(name) == entry.last_write_time())) {
                written.insert(name);
            }
        }
        return written;
    }

    void expectRefused(const std::string& arguments, const std::string& line) const {
        const std::string state = textIn("s");
        ProgramResult result;
        EXPECT_TRUE(writtenBy([&] { result = run(arguments); }).empty());
        EXPECT_EQ(result.status, 2) << arguments;
        EXPECT_EQ(result.err, "cdr: " + line + "\n");
        EXPECT_EQ(textIn("s"), state);
    }
};

constexpr const char* kElsewhere = "; remove it or name another file";

TEST_F(RenderState, MakesOnlyWhatIsMissing) {
    const std::string render = std::string(kRender) + "--hash --json a.json";
    ProgramResult first;
    EXPECT_EQ(writtenBy([&] { first = run(render); }).size(), 5u);
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(linesIn(at("s")).size(), 6u);
    auto whole = files();
    whole.erase("s");
    const std::string table = first.out;

    // All of it is there, times included.
    const std::string json = textIn("a.json");
    ProgramResult again;
    EXPECT_TRUE(writtenBy([&] { again = run(render); }).empty());
    EXPECT_EQ(again.out, "5 of 5 frames are kept in s\n" + table);
    EXPECT_EQ(textIn("a.json"), json);

    // A picture that is gone, one that is another, one frame that was not kept and one that was cut off.
    fs::remove(at("f3.png"));
    std::string picture = textIn("f5.png");
    picture[picture.size() / 2] = static_cast<char>(picture[picture.size() / 2] ^ 1);
    platform::writeText(at("f5.png"), picture);
    std::vector<std::string> lines = linesIn(at("s"));
    lines.erase(lines.begin() + 2);
    writeLines(at("s"), lines);
    fs::resize_file(at("s"), fs::file_size(at("s")) - 7);
    fs::remove(at("a.json"));
    EXPECT_EQ(writtenBy([&] { again = run(render); }),
              (std::set<std::string>{"f3.png", "f4.png", "f5.png", "f7.png"}));
    EXPECT_EQ(again.out.substr(0, again.out.find('\n')), "1 of 5 frames are kept in s");
    auto files = this->files();
    files.erase("s");
    EXPECT_EQ(files, whole);
    EXPECT_TRUE(writtenBy([&] { again = run(render); }).empty());
}

TEST_F(RenderState, IsOfOneRun) {
    succeed(kRender);
    const std::string other =
        std::string("s: is the state of a run with other options or files, another version or device") +
        kElsewhere;
    for (const char* option : {"--seed 7", "--threads 2", "--eye 0,0,1", "--snap-bits 8", "--hash",
                               "--certify c.json", "--ranks cascades", "--aov id"}) {
        expectRefused(std::string(kRender) + option, other);
    }
    expectRefused(std::string("--texture-memory 5 ") + kRender, other);
    expectRefused(std::string("--points 0.5 ") + kRender, other);
    // What changes nothing of a frame.
    for (const char* option : {"--json b.json", "--threads 1", "--aov color"}) {
        succeed(std::string("--quiet --validate --bind ") + kRender + option);
    }
    EXPECT_EQ(linesIn(at("s")).size(), 6u);
}

/// The files that a model refers to, and those of a camera's path.
TEST_F(RenderState, IsOfTheFilesThatWereRead) {
    const fs::path assets = CDR_SOURCE_DIR "/tests/assets";
    for (const char* name : {"well.gltf", "well.bin", "stone.jpg"}) {
        fs::copy_file(assets / name, at(name));
    }
    const std::string render = "render well.gltf --size 32x18 --frames 2 -o f%d.png --state s";
    succeed(render);
    EXPECT_EQ(run(render).out.substr(0, 11), "2 of 2 fram");
    std::string buffer = textIn("well.bin");
    buffer.back() = static_cast<char>(buffer.back() ^ 1);
    platform::writeText(at("well.bin"), buffer);
    expectRefused(
        render,
        std::string("s: is the state of a run with other options or files, another version or device") +
            kElsewhere);
}

/// What a state cannot hold as it is: bytes that are no UTF-8.
TEST_F(RenderState, TakesSceneNamesOfAnyBytes) {
    fs::copy_file(CDR_SOURCE_DIR "/tests/fuzz/seeds/gltf/triangle.gltf", at("odd\xff\tname.gltf"));
    const std::string render = "render 'odd\xff\tname.gltf' --size 16x9 -o f.png --state s";
    succeed(render);
    EXPECT_EQ(run(render).out.substr(0, 11), "1 of 1 fram");
}

TEST_F(RenderState, RefusesAFrameThatItCannotTake) {
    const std::string render =
        "render cubes --size 16x9 -o f.png --certify c.json --technique anchored --state s";
    succeed(render);
    const std::vector<std::string> lines = linesIn(at("s"));
    ASSERT_EQ(lines.size(), 2u);
    const auto good = madeIn(lines[1]);
    EXPECT_FALSE(good.contains("file"));
    using Pointer = nlohmann::ordered_json::json_pointer;
    const auto refuses = [&](const nlohmann::ordered_json& made, std::size_t unit = 0) {
        writeLines(at("s"), {lines[0], madeLineOf(unit, made)});
        expectRefused(render, std::string("s: holds results that do not fit this run") + kElsewhere);
    };
    for (const char* field : {"notes", "row", "cells", "certificate", "picture"}) {
        auto made = good;
        made[field] = 7;
        refuses(made);
        made.erase(field);
        refuses(made);
    }
    for (const auto& [place, value] : std::vector<std::pair<const char*, nlohmann::ordered_json>>{
             {"/notes/0", 7},
             {"/notes/0", "two\nlines"},
             {"/row/technique", "\x1b[31mred"},
             {"/cells/1", "two\nlines"},
             {"/cells/1", 7},
             {"/cells/-", "more"},
             {"/certificate/hash", "\x7f"},
             {"/certificate/first_refused", nlohmann::ordered_json::array({1})},
             {"/certificate/first_refused", {1, -1}},
             {"/certificate/first_refused", 1}}) {
        auto made = good;
        made[Pointer(place)] = value;
        refuses(made);
    }
    auto refused = good;
    refused["certificate"]["first_refused"] = {1, 1};
    for (const char* place : {"/certificate/frame", "/certificate/refused"}) {
        auto made = refused;
        made[Pointer(place)] = 1e300;
        refuses(made);
    }
    refuses(good, 1); // of one frame
    // What it holds of a picture is not written in the place of one.
    auto made = good;
    made["file"] = nlohmann::ordered_json::binary({1, 2, 3});
    writeLines(at("s"), {lines[0], madeLineOf(0, made)});
    EXPECT_TRUE(writtenBy([&] { succeed(render); }).empty());
}

TEST_F(RenderState, RefusesWhatIsNoState) {
    succeed(kRender);
    auto damaged = linesIn(at("s"));
    damaged[3].back() = ' ';
    writeLines(at("s"), damaged);
    expectRefused(kRender, std::string("s: is damaged") + kElsewhere);
    platform::writeText(at("s"), "{}\n");
    expectRefused(kRender, std::string("s: is no state") + kElsewhere);
}

TEST_F(RenderState, RefusesFilesThatItCannotKeep) {
    const std::string render = "render cubes --size 32x18 -o f.png ";
    for (const auto& [option, line] :
         {std::pair("--state .", ".: names a folder, not a file to write"),
          std::pair("--state no/s", "no/s: cannot be written, its folder is missing or read-only"),
          std::pair("--state /dev/full", "/dev/full: not a regular file"),
          std::pair("--state f.png", "f.png: both -o and --state would write it"),
          std::pair("--state s --trace t.json",
                    "--trace needs all frames, and --state does not draw those that are kept: give one")}) {
        expectRefused(render + option, line);
    }
    EXPECT_TRUE(files().empty());
}

TEST_F(RenderState, GoesOnWithACertificate) {
    const std::string render =
        "render afc --technique anchored --size 160x90 --frames 3 --aov wrong -o f%d.png --json a.json "
        "--certify c.json --state s";
    succeed(render);
    auto whole = files();
    whole.erase("s");
    for (const char* name : {"f1.png", "a.json", "c.json"}) {
        fs::remove(at(name));
    }
    ProgramResult again;
    EXPECT_EQ(writtenBy([&] { again = run(render); }), std::set<std::string>{"f1.png"});
    EXPECT_EQ(again.status, 0) << again.err;
    auto files = this->files();
    files.erase("s");
    EXPECT_EQ(files, whole);
}

/// A frame that was refused has no picture. It is not made again, and the run ends as it did.
TEST_F(RenderState, KeepsThatAFrameWasRefused) {
    const test::Fault beside{.call = "vkCmdSetViewport", .times = test::kForever, .result = 2};
    const std::string render =
        "--quiet render afc --technique anchored --size 160x90 -o f.png --certify c.json --state s";
    const ProgramResult first = run(render, beside.environment());
    ASSERT_EQ(first.status, 3) << first.err;
    const std::string certificate = textIn("c.json");
    fs::remove(at("c.json"));
    const ProgramResult again = run(render, beside.environment());
    EXPECT_EQ(again.status, 3);
    EXPECT_EQ(again.err, first.err);
    EXPECT_EQ(textIn("c.json"), certificate);
    EXPECT_EQ(linesIn(at("s")).size(), 2u);
    EXPECT_FALSE(fs::exists(at("f.png")));
}

/// Before a device is lost, frames are kept, and the next run goes on from there.
TEST_F(RenderState, GoesOnBehindALostDevice) {
    const test::Fault lost{.call = "vkQueueSubmit2", .after = 4};
    const ProgramResult first = run(kRender, lost.environment());
    ASSERT_EQ(first.status, 1) << first.err;
    const std::size_t kept = linesIn(at("s")).size() - 1;
    ASSERT_GT(kept, 0u);
    ASSERT_LT(kept, 5u);
    ProgramResult again;
    EXPECT_EQ(writtenBy([&] { again = run(kRender); }).size(), 5 - kept);
    EXPECT_EQ(again.status, 0) << again.err;
}

} // namespace
} // namespace cdr::cli_test
