#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace cdr::test {

/// What a program that a shell ran ended with and printed.
struct ShellResult {
    int status = -1;
    std::string out;
    std::string err;
};

/// Runs a command in a shell. @return the exit status; -1 where a signal ended the shell.
inline int statusOf(const std::string& command) {
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The bytes of a file; none where there is none.
inline std::string readText(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// Expects that a program ended with a status after one line that says `what`.
inline void expectOneLine(const ShellResult& result, int status, const std::string& what = "") {
    EXPECT_EQ(result.status, status) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
}

} // namespace cdr::test
