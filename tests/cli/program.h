#pragma once

#include "../support/temporary_folder.h"

#include <filesystem>
#include <string>

namespace cdr::cli_test {

struct ProgramResult {
    int status = -1;
    std::string out;
    std::string err;
};

/// Runs the cdr program in a shell with `arguments` as typed, in `folder`.
/// @param environment assignments for the program alone, as typed before it.
ProgramResult runProgram(const std::string& arguments, const std::filesystem::path& folder,
                         const std::string& environment = "");

using test::TemporaryFolder;

std::string readText(const std::filesystem::path& path);

} // namespace cdr::cli_test
