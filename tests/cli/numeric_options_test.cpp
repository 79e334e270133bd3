#include "program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace cdr::cli_test {

namespace {

using NumericOptionsList = FolderTest;
using WholeNumbers = FolderTest;

/// Ends and middles of the ranges of float32, float64 and whole numbers, and what is no number. None asks for much work
/// and is taken: whole numbers are few, or more than any option allows.
constexpr std::array kNumbers{"0",
                              "-0",
                              "1",
                              "7",
                              "65",
                              "-1",
                              "0.5",
                              "-0.5",
                              "nan",
                              "-nan",
                              "inf",
                              "-inf",
                              "1e400",
                              "-1e400",
                              "4.9e-324",
                              "-4.9e-324",
                              "1e-310",
                              "2.3e-308",
                              "1e-60",
                              "1e-46",
                              "1.4e-45",
                              "1e-41",
                              "1e-30",
                              "1e-38",
                              "1e-7",
                              "16777217",
                              "3.4e38",
                              "3.5e38",
                              "1e30",
                              "1.1e30",
                              "1e60",
                              "1e150",
                              "1e300",
                              "1.7976931348623157e308",
                              "-1.7976931348623157e308",
                              "4294967295",
                              "4294967296",
                              "-4294967295",
                              "9223372036854775808",
                              "18446744073709551615",
                              "18446744073709551616",
                              "1e",
                              "0x",
                              "0x1p-1074",
                              "1,2",
                              "1e5,",
                              ""};

/// A command at its smallest, and where numbers stand in its options as @.
struct Numbers {
    const char* command;
    std::vector<const char*> options;
    const char* name;

    friend std::ostream& operator<<(std::ostream& out, const Numbers& numbers) {
        return out << numbers.command;
    }
};

const std::vector<Numbers> kNumbersOfCommands{
    {"render cubes --size 16x16 -o a%d.png",
     {"--fov @",
      "--exposure @",
      "--near @",
      "--far @",
      "--near @ --far 1e30",
      "--near 1e-30 --far @",
      "--depth anchored --split fitted --near @",
      "--depth anchored --split fitted --far @",
      "--split minimax:4 --depth log --near @",
      "--frame @",
      "--frames @",
      "--threads @",
      "--seed @",
      "--snap-bits @",
      "--translucency sorted --translucency-memory @",
      "--texture-memory @",
      "--points @",
      "--split ratio:@",
      "--split count:@",
      "--split at:@",
      "--split at:1,@",
      "--split minimax:@",
      "--split fitted:@",
      "--split fitted:@px",
      "--split fitted:1px,max=@",
      "--depth anchored --split fitted:@",
      "--detail object:@",
      "--detail cascade:@",
      "--detail cluster:@",
      "--targets pool:@",
      "--occlusion @",
      "--fog @",
      "--fog 10,@,0,0",
      "--fog 1,1,1,@",
      "--targets layers --split count:3 --focus @:1",
      "--targets layers --split count:3 --focus 100:@",
      "--targets layers --split count:3 --focus @:@:blend",
      "--eye @,0,0",
      "--eye 0,@,@",
      "--target @,0,1",
      "--direction 0,@,-1",
      "--direction @,@,@",
      "--up @,1,0",
      "--eye @,@,@ --target @,@,0",
      "--size @x8",
      "--size 8x@",
      "--stereo parallel --eye-distance @",
      "--stereo parallel --eye-distance 1 --converge @",
      "--stereo parallel --eye-distance @ --converge @"},
     "Render"},
    {"render " CDR_SOURCE_DIR "/tests/assets/stage.glb --size 16x16 -o a.png",
     {"--camera @", "--gltf-scene @"},
     "Stage"},
    {"render " CDR_SOURCE_DIR "/tests/assets/machine.glb --size 16x16 -o a%d.png",
     {"--time @", "--fps @", "--animation @", "--time @ --fps 24 --frames 2", "--time 1 --fps @ --frame 3"},
     "Machine"},
    {"render alley --size 16x16 -o a.png --shadows anchored",
     {"--shadow-texels @", "--near @", "--far @", "--fov @"},
     "RenderedShadows"},
    {"render sheets --size 16x16 -o a.png --translucency sorted",
     {"--translucency-memory @", "--near @", "--far @", "--fog @", "--occlusion @", "--exposure @"},
     "Sheets"},
    {"render orbit --size 16x16 -o a.png --technique anchored",
     {"--fov @", "--near @", "--frame @"},
     "RenderedOrbit"},
    {"advise --separation 1",
     {"--near @", "--far @", "--fov @", "--height @", "--at @", "--span @", "--sub-pixel-bits @", "--slope @",
      "--sub-pixel-bits 8 --slope @", "--near @ --far 1e30 --at 1e30", "--separation @",
      "--separation @ --near 1e-10 --far 1e25"},
     "Advise"},
    {"advise --separation 1 --far 1000 --format d32f --techniques reversed --measured --size 16x16 --frames 1",
     {"--seed @", "--threads @", "--frames @"},
     "AdviseMeasured"},
    {"precision", {"--near @ --far 1e-1", "--far @"}, "Precision"},
    {"probe --size 16x16 --techniques standard --formats d32f",
     {"--distances @", "--seed @", "--threads @", "--snap-bits @"},
     "Probe"},
    {"rivals cubes --frames 1 --distances 1 --size 16x16 --techniques anchored --rivals atomic-log",
     {"--seed @", "--threads @", "--distances @", "--frames @", "--size @x8"},
     "Rivals"},
    {"pictures --scenes cubes --techniques log --frames 1 --size 16x16 --out p",
     {"--seed @", "--threads @", "--snap-bits @", "--frames @"},
     "Pictures"},
    // --rounds is refused without the other program, which would be started.
    {"timing --frames 1 --size 16x16 --modes log",
     {"--in-flight @", "--seed @", "--threads @", "--frames @", "--rounds @"},
     "Timing"},
    {"flicker --frames 1 --size 16x16 --techniques standard",
     {"--flip-every @", "--seed @", "--threads @", "--snap-bits @", "--frames @"},
     "Flicker"},
    {"focus --frames 1 --cameras 1 --size 16x16",
     {"--distance @", "--aperture @", "--seed @", "--distance @ --aperture @", "--frames @", "--cameras @",
      "--threads @"},
     "Focus"},
    {"effects --frames 1 --size 16x16",
     {"--occlusion @", "--fog @", "--frames @", "--threads @", "--seed @"},
     "Effects"},
    {"detail cubes --frames 1 --size 16x16",
     {"--pixels @", "--frames @", "--threads @", "--seed @"},
     "Detail"},
    {"shadows cubes --size 16x16",
     {"--shadow-texels @", "--near @", "--far @", "--fov @", "--seed @", "--snap-bits @", "--threads @",
      "--frame @", "--frames @"},
     "Shadows"},
    {"models " CDR_SOURCE_DIR "/tests/assets/machine.glb --size 16x16",
     {"--time @", "--camera @", "--threads @", "--size @x8"},
     "Models"},
    {"coplanar --frames 1 --search-views 1 --size 16x16 --techniques standard",
     {"--seed @", "--threads @", "--snap-bits @", "--frames @", "--search-views @",
      "--constants 0 --slopes @", "--slopes 0 --constants @"},
     "Coplanar"},
    {"inspect cubes --size 16x16 --techniques standard",
     {"--fail-above @", "--seed @", "--threads @", "--snap-bits @", "--frames @", "--eye 0,0,5 --fov @",
      "--eye 0,0,5 --near @", "--eye 0,0,5 --far @"},
     "Inspect"},
    {"translucency --size 16x16 --repeats 0 --cascades 1",
     {"--translucency-memory @", "--seed @", "--cascades @", "--repeats @", "--threads @"},
     "Translucency"},
    {"scaling --size 16x16 --draws 1 --threads 1 --cascades 1 --repeats 1 --targets single",
     {"--seed @", "--draws @", "--repeats @", "--cascades @", "--threads @"},
     "Scaling"},
    {"scaling --ranks --draws 1 --cascades 1 --repeats 1", {"--heights @"}, "ScalingOfRanks"},
    {"scaling --size 16x16 --draws 1 --repeats 1", {"--project @", "--project 4 --frames @"}, "Projection"},
    {"report --smallest --sections precision -o r", {"--threads @", "--seed @"}, "Report"},
    {"orbit --frames 1 --size 16x16 --techniques standard",
     {"--frames @", "--threads @", "--snap-bits @"},
     "Orbit"},
    {"translucency " CDR_SOURCE_DIR "/tests/assets/veils.glb --size 16x16 --repeats 0 --cascades 1",
     {"--time @"},
     "TranslucencyAtATime"},
    {"inspect " CDR_SOURCE_DIR "/tests/assets/stage.glb --frames 1 --size 16x16 --techniques standard",
     {"--time @", "--camera @", "--gltf-scene @"},
     "InspectAtATime"},
    {"inspect " CDR_SOURCE_DIR "/tests/assets/machine.glb --size 16x16 --techniques standard",
     {"--gltf-scene @", "--camera @"},
     "InspectMachine"},
    {"shadows " CDR_SOURCE_DIR "/tests/assets/stage.glb --size 16x16",
     {"--time @", "--camera @", "--gltf-scene @"},
     "ShadowsAtATime"},
    {"effects " CDR_SOURCE_DIR "/tests/assets/stage.glb --frames 1 --size 16x16",
     {"--time @", "--camera @", "--gltf-scene @"},
     "EffectsAtATime"},
    {"detail " CDR_SOURCE_DIR "/tests/assets/stage.glb --frames 1 --size 16x16",
     {"--time @", "--camera @", "--gltf-scene @"},
     "DetailAtATime"},
    {"focus " CDR_SOURCE_DIR "/tests/assets/stage.glb --frames 1 --cameras 1 --size 16x16",
     {"--time @", "--camera @", "--gltf-scene @"},
     "FocusAtATime"}};

constexpr int kMaxSeconds = 4;
constexpr int kSanitizers = 30; ///< times as long

std::string replaced(std::string text, const std::string& number) {
    for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at + number.size())) {
        text.replace(at, 1, number);
    }
    return text;
}

/// "--near @" with a space instead of "=" would take "-1" for an option.
std::string quoted(const std::string& option) {
    std::istringstream words(option);
    std::string line;
    std::string word;
    while (words >> word) {
        const bool isName = word.starts_with("--") && word.find('@') == std::string::npos;
        line += isName ? " " + word + "=" : "'" + word + "'";
    }
    return line;
}

/// A command's arguments with a number in one of its options. The command's own value of an option in it is left out.
std::string argumentsWith(std::string command, const std::string& option, const std::string& number) {
    std::istringstream words(option);
    for (std::string word; words >> word;) {
        const std::size_t at = command.find(" " + word + " ");
        if (word.starts_with("--") && at != std::string::npos) {
            command.erase(at, command.find(' ', at + word.size() + 2) - at);
        }
    }
    return command + replaced(quoted(option), number);
}

/// Ends a run that works longer than any of them does, by the CPU time that it takes. What else runs matters little. Sanitizers,
/// which stand where the library of file faults would, are slower. A run that waits for nothing ends as well.
std::string cpuLimit() {
    const bool isSanitized = std::string(CDR_FILE_FAULTS).empty();
    return "ulimit -t " + std::to_string(isSanitized ? kMaxSeconds * kSanitizers : kMaxSeconds) +
           " && timeout 1000 ";
}

class NumericOptions : public testing::TestWithParam<Numbers> {};

/// Each run gives an answer, or prints one line, ends with status 2 and writes nothing.
TEST_P(NumericOptions, EveryNumberIsTakenOrRefused) {
    // All take half an hour; every suite runs others of them only when the list changes. Each option gets another number.
    const std::size_t stride = takesAllCases() ? 1 : 37;
    std::size_t first = 0;
    for (const char* option : GetParam().options) {
        std::size_t number = first++;
        for (const char* value : kNumbers) {
            if (number++ % stride != 0) {
                continue;
            }
            const std::string arguments = argumentsWith(GetParam().command, option, value);
            SCOPED_TRACE(arguments);
            const TemporaryFolder folder;
            const ProgramResult result = runProgram(arguments, folder.path(), cpuLimit());
            const bool isFailedCheck =
                result.status == 3 && arguments.find("--fail-above") != std::string::npos;
            EXPECT_TRUE(result.status == 0 || result.status == 2 || isFailedCheck)
                << result.status << " " << result.err;
            expectWholeFiles(folder);
            if (result.status == 2) {
                EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
                EXPECT_TRUE(folder.isEmpty());
            }
        }
    }
}

/// Also where the option would not matter.
TEST_P(NumericOptions, WhatIsNoFiniteNumberIsRefused) {
    constexpr std::array kNoNumbers{"nan", "-nan", "inf", "-inf", "1e400", "-1e400", "1e", "x", ""};
    const std::size_t stride = takesAllCases() ? 1 : 13;
    std::size_t number = 0;
    for (const char* option : GetParam().options) {
        for (const char* value : kNoNumbers) {
            if (number++ % stride != 0) {
                continue;
            }
            const std::string arguments = argumentsWith(GetParam().command, option, value);
            const TemporaryFolder folder;
            expectRefusal(arguments, folder.path(), "", cpuLimit());
            EXPECT_TRUE(folder.isEmpty()) << arguments;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Commands, NumericOptions, testing::ValuesIn(kNumbersOfCommands),
                         [](const auto& row) { return std::string(row.param.name); });

/// Each line's first two words in a command's help: an option and its type, where it describes one.
std::vector<std::pair<std::string, std::string>> typedOptions(const std::string& command,
                                                              const std::filesystem::path& folder) {
    std::vector<std::pair<std::string, std::string>> found;
    std::istringstream help(runProgram(command + " --help", folder).out);
    for (std::string line; std::getline(help, line);) {
        std::istringstream words(line);
        auto& [name, type] = found.emplace_back();
        words >> name >> type;
    }
    return found;
}

/// Options that take a number by itself stand above.
TEST_F(NumericOptionsList, HoldsEveryOption) {
    std::set<std::string> listed;
    for (const Numbers& numbers : kNumbersOfCommands) {
        const std::string command =
            std::string(numbers.command).substr(0, std::string(numbers.command).find(' '));
        for (const char* option : numbers.options) {
            std::istringstream words(option);
            for (std::string word; words >> word;) {
                listed.insert(command + " " + word);
            }
        }
    }
    std::size_t count = 0;
    for (const std::string& command : commandNames()) {
        if (command == "view") {
            continue; // it starts the viewer, whose tests these are
        }
        for (const auto& [name, type] : typedOptions(command, folder())) {
            if (type == "UINT" || type == "INT" || type == "FLOAT") {
                ++count;
                EXPECT_TRUE(listed.contains(command + " " + name)) << command << " " << name;
            }
        }
    }
    EXPECT_GT(count, 60u);
}

/// CLI11 takes what is 2^64 less for the same.
TEST_F(WholeNumbers, AreNotNegative) {
    for (const std::string& command : commandNames()) {
        for (const auto& [name, type] : typedOptions(command, folder())) {
            if (type == "UINT") {
                expectRefusal(command + " " + name + "=-18446744073709551615",
                              "from 0 to 18446744073709551615, not -18446744073709551615");
                expectRefusal(command + " '" + name + "= -1'", "from 0 to 18446744073709551615, not  -1");
                expectRefusal(command + " " + name + "=18446744073709551617",
                              "from 0 to 18446744073709551615, not 18446744073709551617");
            }
        }
    }
}

/// Of every command. Other bases are refused, and leading zeros say nothing.
TEST_F(WholeNumbers, AreDecimal) {
    std::size_t options = 0;
    for (const std::string& command : commandNames()) {
        for (const auto& [name, type] : typedOptions(command, folder())) {
            if (type == "UINT" || type == "INT") {
                ++options;
                expectRefusal(command + " " + name + "=0x1", "in decimal, not 0x1");
            }
        }
    }
    EXPECT_GT(options, 30u);
    for (const char* frame : {"010", "008", "00", "-01"}) {
        const std::string arguments = std::string("render afc --size 8x8 --frame=") + frame + " -o f%d.png";
        const bool isTaken = std::string(frame) != "-01";
        EXPECT_EQ(run(arguments).status, isTaken ? 0 : 2) << frame;
    }
    for (const char* name : {"f10.png", "f8.png", "f0.png"}) {
        EXPECT_TRUE(std::filesystem::exists(at(name))) << name;
    }
}

} // namespace

} // namespace cdr::cli_test
