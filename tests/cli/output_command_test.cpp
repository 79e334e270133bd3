#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace cdr::cli_test {

namespace {

namespace fs = std::filesystem;
using Outputs = FolderTest;
using Advise = FolderTest;

/// Runs the program with a redirection of its own, such as ">/dev/full".
ProgramResult runRedirected(const std::string& arguments, const std::string& redirection,
                            const fs::path& folder) {
    return runProgram(arguments, folder, "sh -c '\"$0\" \"$@\" " + redirection + "'");
}

TEST_F(Outputs, WhatStandardOutputCannotTakeIsAFailure) {
    for (const char* arguments : {"--quiet precision --json", "precision", "--version", "precision --help"}) {
        const ProgramResult result = runRedirected(arguments, ">/dev/full", folder());
        EXPECT_EQ(result.status, 1) << arguments;
        EXPECT_EQ(result.err, "cdr: standard output: write failed: No space left on device\n") << arguments;
    }
}

TEST_F(Outputs, AFullStandardErrorChangesNoStatus) {
    EXPECT_EQ(runRedirected("render nosuch", "2>/dev/full", folder()).status, 2);
    EXPECT_EQ(runRedirected("precision --json /dev/fd/3", "2>/dev/full 3>/dev/full", folder()).status, 1);
}

TEST_F(Outputs, GoIntoDescriptorsAndWhatALinkPointsAt) {
    const ProgramResult result = succeed("--quiet precision --json /dev/fd/1");
    EXPECT_EQ(nlohmann::json::parse(result.out).at("command"), "precision");
    EXPECT_EQ(runRedirected("precision --json /dev/fd/3", "3>/dev/full", folder()).err,
              "cdr: /dev/fd/3: write failed: No space left on device\n");
    fs::create_symlink("to.json", at("link.json"));
    succeed("precision --json link.json");
    EXPECT_TRUE(fs::is_symlink(at("link.json")));
    EXPECT_EQ(jsonIn("to.json").at("command"), "precision");
}

TEST_F(Advise, EndsForTheSmallestNumbers) {
    for (const char* arguments : {"advise --separation 4.9e-324", "advise --separation 1e-310",
                                  "advise --separation 1 --fov 1e-28"}) {
        const ProgramResult result = succeed(arguments);
        EXPECT_FALSE(result.out.empty()) << arguments;
    }
}

} // namespace

} // namespace cdr::cli_test
