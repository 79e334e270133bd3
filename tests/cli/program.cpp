#include "program.h"

#include "../support/launched.h"

#include <cdr/image/codec.h>
#include <cdr/platform/base64.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <program/sha256.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace cdr::cli_test {

namespace fs = std::filesystem;

std::vector<std::string> linesIn(const fs::path& path) {
    std::vector<std::string> lines;
    std::istringstream stream(readText(path));
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

void writeLines(const fs::path& path, const std::vector<std::string>& lines, const std::string& cutOff) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    platform::writeText(path, text + cutOff);
}

const gpu::DeviceInfo& deviceInfo() {
    static const gpu::DeviceInfo info = [] {
        const gpu::Instance instance;
        return gpu::Device(instance, "").info();
    }();
    return info;
}

bool hasD24() {
    const auto& formats = deviceInfo().depthFormats;
    return std::find(formats.begin(), formats.end(), depth::DepthFormat::d24) != formats.end();
}

double snapReach() {
    const bool isLavapipe = deviceInfo().name.find("llvmpipe") != std::string::npos;
    return isLavapipe ? 0.0 : std::exp2(-1.0 - deviceInfo().subPixelBits);
}

bool canDrawGpuDriven() {
    return deviceInfo().gpuDrivenMissing.empty();
}

bool lacksPage(const ProgramResult& result) {
    return result.err.find("was built without the report's page") != std::string::npos;
}

ProgramResult runProgram(const std::string& arguments, const fs::path& folder,
                         const std::string& environment) {
    // What the program prints goes beside the folder, which stays as the program leaves it.
    const std::string log = folder.string() + ".log";
    const std::string command = "cd '" + folder.string() + "' && " + environment + " '" CDR_PROGRAM "' " +
                                arguments + " >'" + log + ".out' 2>'" + log + ".err' </dev/null";
    ProgramResult result{.status = test::statusOf(command),
                         .out = readText(log + ".out"),
                         .err = test::withoutWarningsOfEvents(readText(log + ".err"))};
    fs::remove(log + ".out");
    fs::remove(log + ".err");
    return result;
}

std::string preloading(const fs::path& library) {
    return "LD_LIBRARY_PATH=\"" + library.parent_path().string() +
           "${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}\" LD_PRELOAD=" + library.filename().string();
}

ProgramResult succeed(const std::string& arguments, const fs::path& folder, const std::string& environment) {
    ProgramResult result = runProgram(arguments, folder, environment);
    EXPECT_EQ(result.status, 0) << arguments << ": " << result.err;
    return result;
}

nlohmann::json documentOf(const std::string& arguments, const fs::path& folder) {
    const ProgramResult result = succeed(arguments + " --json document.json", folder);
    return result.status == 0 ? nlohmann::json::parse(readText(folder / "document.json")) : nlohmann::json();
}

void expectRefusal(const std::string& arguments, const fs::path& folder, const std::string& what,
                   const std::string& environment) {
    SCOPED_TRACE(arguments);
    const ProgramResult result = runProgram(arguments, folder, environment);
    expectOneLine(result, 2, what);
    // It repeats the word, which may be all that `what` is.
    const std::string noOption = "has no option";
    EXPECT_TRUE(what.find(noOption) != std::string::npos || result.err.find(noOption) == std::string::npos)
        << result.err;
    EXPECT_EQ(result.out, "");
}

std::vector<std::string> commandNames() {
    const TemporaryFolder folder;
    const ProgramResult result = runProgram("completions fish", folder.path());
    std::vector<std::string> names;
    std::istringstream lines(result.out);
    const std::string before = "__fish_use_subcommand -a ";
    for (std::string line; std::getline(lines, line);) {
        if (const std::size_t at = line.find(before); at != std::string::npos) {
            const std::size_t begin = at + before.size();
            names.push_back(line.substr(begin, line.find(' ', begin) - begin));
        }
    }
    return names;
}

std::map<std::string, std::string> filesIn(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            const std::string text = readText(entry.path());
            files[entry.path().lexically_relative(folder).string()] =
                entry.path().extension() == ".json"
                    ? std::regex_replace(text,
                                         std::regex("(\"(?:[a-z_]+_ms|execute_speedup|ci95)\": )"
                                                    "(?:\\[[^\\]]*\\]|[^,\n]+)"),
                                         "$1")
                    : text;
        }
    }
    return files;
}

void expectWholeFiles(const TemporaryFolder& folder, bool mayHide) {
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
        } else if (entry.path().extension() == ".csv") {
            EXPECT_TRUE(readText(entry.path()).ends_with("\n")) << name;
        } else if (entry.path().extension() == ".svg") {
            EXPECT_NE(readText(entry.path()).find("</svg>"), std::string::npos) << name;
        } else if (entry.is_regular_file()) {
            EXPECT_GT(entry.file_size(), 0u) << name;
        }
    }
}

nlohmann::ordered_json recordIn(const std::string& line) {
    return nlohmann::ordered_json::parse(line.substr(line.find(' ')));
}

std::string stateLineOf(std::size_t unit, const nlohmann::ordered_json& made) {
    const std::string json = nlohmann::ordered_json{{"unit", unit}, {"made", made}}.dump();
    return program::sha256Of(json) + " " + json;
}

nlohmann::ordered_json madeIn(const std::string& line) {
    const auto text = recordIn(line).at("made").get<std::string>();
    return nlohmann::ordered_json::from_cbor(platform::fromBase64(text).value());
}

std::string madeLineOf(std::size_t unit, const nlohmann::ordered_json& made) {
    return stateLineOf(unit, platform::toBase64(nlohmann::ordered_json::to_cbor(made)));
}

image::ImageRgba8 readPicture(const std::filesystem::path& path) {
    return image::decodeImage(platform::readFile(path, 1 << 26), path.string());
}

} // namespace cdr::cli_test
