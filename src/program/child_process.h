#pragma once

#include <sys/types.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::program {

/// Another program, started from an argument vector without a shell. It inherits only the three standard
/// files. Its standard error is kept, to be quoted in messages.
class ChildProcess {
  public:
    /// Where its standard output goes.
    struct Output {
        std::optional<std::filesystem::path> file; ///< created or emptied; /dev/null when empty
    };

    /// @param arguments the program, looked up in PATH, then its arguments.
    /// base::InputError when there is no such program, or what has its name is none. base::RunError when it cannot be
    /// started, or the file of its output cannot be written.
    ChildProcess(std::vector<std::string> arguments, const Output& output);
    /// Closes the input of a child that was not waited for, and kills it.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Sends bytes to its standard input; blocks while it is busy. RunError with the end of its standard
    /// error when it no longer reads.
    void write(std::span<const std::uint8_t> bytes);

    /// Closes its standard input and waits for it to end. RunError with the end of its standard error unless
    /// it exits with status 0.
    void finish();

  private:
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::string lastWords() const;
    void closeInput();
    int wait();

    std::string m_name;
    std::unique_ptr<std::FILE, CloseFile> m_errors; ///< has no name, removed when closed
    int m_input = -1;
    pid_t m_child = -1;
};

/// Whether a program of that name can be started.
bool isInstalled(const std::string& program);

/// `word` as a POSIX shell must read it to mean it: as it is where nothing in it is special, else in single quotes.
std::string shellQuoted(std::string_view word);

} // namespace cdr::program
