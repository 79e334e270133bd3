#pragma once

#include "../support/all_cases.h"
#include "../support/shell.h"
#include "../support/temporary_folder.h"

#include <cdr/gpu/device.h>
#include <cdr/image/image.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cdr::cli_test {

using ProgramResult = test::ShellResult;

/// Runs the cdr program in a shell with `arguments` as typed, in `folder`.
/// @param environment assignments for the program alone, as typed before it.
ProgramResult runProgram(const std::string& arguments, const std::filesystem::path& folder,
                         const std::string& environment = "");

/// Assignments for a shell that load a library before the system's. LD_PRELOAD splits at blanks, which its folder may have.
std::string preloading(const std::filesystem::path& library);

/// Runs the program, which has to succeed.
ProgramResult succeed(const std::string& arguments, const std::filesystem::path& folder,
                      const std::string& environment = "");

/// Runs the program, which has to succeed, with `--json`. @return the document; null where it fails.
nlohmann::json documentOf(const std::string& arguments, const std::filesystem::path& folder);

/// Runs the program, which has to end with exit status 2 and print nothing but one line that says `what`. An option that does
/// not exist is another refusal, unless `what` is about that.
void expectRefusal(const std::string& arguments, const std::filesystem::path& folder,
                   const std::string& what = "", const std::string& environment = "");

/// The commands that bare `cdr` lists.
std::vector<std::string> commandNames();

/// The device that the program takes when none is named.
const gpu::DeviceInfo& deviceInfo();

/// Whether the device can draw to 24 bits of depth.
bool hasD24();

/// How far, in pixels, the device may move a surface by snapping its vertices; 0 on lavapipe, which tests/render measures.
double snapReach();

/// Whether the device can cull and bin.
bool canDrawGpuDriven();

/// Whether the program was built without the report's page, and says so.
bool lacksPage(const ProgramResult& result);

constexpr const char* kNoPage = "built without the report's page: tools/setup.sh fetches its npm packages";
constexpr const char* kNoD24 = "left out: d24, which the device lacks";
constexpr const char* kNoGpuDriven = "left out: gpu-driven submission, which the device lacks";

using test::readText;
using test::takesAllCases;
using test::TemporaryFolder;

/// A test in a folder of its own, where the program runs.
class FolderTest : public testing::Test {
  protected:
    const std::filesystem::path& folder() const { return m_folder.path(); }
    bool folderIsEmpty() const { return m_folder.isEmpty(); }
    std::filesystem::path at(const std::string& name) const { return folder() / name; }
    std::string textIn(const std::string& name) const { return readText(at(name)); }
    nlohmann::json jsonIn(const std::string& name) const { return nlohmann::json::parse(textIn(name)); }

    ProgramResult run(const std::string& arguments, const std::string& environment = "") const {
        return runProgram(arguments, folder(), environment);
    }
    ProgramResult succeed(const std::string& arguments, const std::string& environment = "") const {
        return cli_test::succeed(arguments, folder(), environment);
    }
    nlohmann::json documentOf(const std::string& arguments) const {
        return cli_test::documentOf(arguments, folder());
    }
    void expectRefusal(const std::string& arguments, const std::string& what = "",
                       const std::string& environment = "") const {
        cli_test::expectRefusal(arguments, folder(), what, environment);
    }

  private:
    TemporaryFolder m_folder;
};

/// Those of a text file, without their ends.
std::vector<std::string> linesIn(const std::filesystem::path& path);
/// Each line with its end, and then a text.
void writeLines(const std::filesystem::path& path, const std::vector<std::string>& lines,
                const std::string& cutOff = "");

/// By name, every file of a folder; JSON without what measures time.
std::map<std::string, std::string> filesIn(const std::filesystem::path& folder);

/// Expects files that can be read, and hidden ones only where they may stay.
void expectWholeFiles(const TemporaryFolder& folder, bool mayHide = false);

/// What a line of a state keeps: a unit of work and what was made of it.
nlohmann::ordered_json recordIn(const std::string& line);
/// The line that a state keeps of a unit.
std::string stateLineOf(std::size_t unit, const nlohmann::ordered_json& made);
/// What was made, as runs::KeptRanks keeps it.
nlohmann::ordered_json madeIn(const std::string& line);
std::string madeLineOf(std::size_t unit, const nlohmann::ordered_json& made);

image::ImageRgba8 readPicture(const std::filesystem::path& path);

} // namespace cdr::cli_test
