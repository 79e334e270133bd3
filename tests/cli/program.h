#pragma once

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

/// A fresh empty folder that is removed with the object.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return m_path; }
    bool isEmpty() const { return std::filesystem::is_empty(m_path); }

  private:
    std::filesystem::path m_path;
};

std::string readText(const std::filesystem::path& path);

} // namespace cdr::cli_test
