#include <cdr/base/error.h>

#include <fcntl.h>
#include <program/child_process.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace cdr::program {

namespace {

/// The files that the child has as its standard files.
class FileActions {
  public:
    FileActions() { posix_spawn_file_actions_init(&m_actions); }
    ~FileActions() { posix_spawn_file_actions_destroy(&m_actions); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    void redirect(int from, int to) { posix_spawn_file_actions_adddup2(&m_actions, from, to); }
    const posix_spawn_file_actions_t* get() const { return &m_actions; }

  private:
    posix_spawn_file_actions_t m_actions{};
};

/// No signal is kept from the child, whichever its parent holds back.
class SignalsLetThrough {
  public:
    SignalsLetThrough() {
        sigset_t none;
        ::sigemptyset(&none);
        posix_spawnattr_init(&m_attributes);
        posix_spawnattr_setsigmask(&m_attributes, &none);
        posix_spawnattr_setflags(&m_attributes, POSIX_SPAWN_SETSIGMASK);
    }
    ~SignalsLetThrough() { posix_spawnattr_destroy(&m_attributes); }
    SignalsLetThrough(const SignalsLetThrough&) = delete;
    SignalsLetThrough& operator=(const SignalsLetThrough&) = delete;

    const posix_spawnattr_t* get() const { return &m_attributes; }

  private:
    posix_spawnattr_t m_attributes{};
};

} // namespace

ChildProcess::ChildProcess(std::vector<std::string> arguments, const Output& output)
    : m_name(arguments.at(0)),
      m_errors(std::tmpfile()) {
    // Opened here, so that it is not taken for a failure to start the program. "e": no other child has it.
    const std::string file = output.file ? output.file->string() : "/dev/null";
    const std::unique_ptr<std::FILE, CloseFile> out(std::fopen(file.c_str(), "we"));
    if (!out) {
        throw base::RunError(file + ": cannot be written: " + std::strerror(errno));
    }
    // A socket and not a pipe: writing to one whose reader has gone can fail without raising SIGPIPE.
    std::array<int, 2> ends{-1, -1};
    if (!m_errors || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        throw base::RunError(m_name + ": cannot be started: " + std::strerror(errno));
    }
    ::fcntl(::fileno(m_errors.get()), F_SETFD, FD_CLOEXEC);
    m_input = ends[0];
    ::shutdown(ends[1], SHUT_WR);
    FileActions actions;
    actions.redirect(ends[1], STDIN_FILENO);
    actions.redirect(::fileno(out.get()), STDOUT_FILENO);
    actions.redirect(::fileno(m_errors.get()), STDERR_FILENO);
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    const int error =
        ::posix_spawnp(&m_child, argv[0], actions.get(), SignalsLetThrough().get(), argv.data(), environ);
    ::close(ends[1]);
    if (error != 0) {
        closeInput();
        m_child = -1;
        if (error == ENOENT) {
            throw base::InputError(m_name + " is not installed");
        }
        const std::string what = m_name + ": cannot be started: " + std::strerror(error);
        if (error == EACCES || error == ENOEXEC) { // a folder, or a file that is no program
            throw base::InputError(what);
        }
        throw base::RunError(what);
    }
}

ChildProcess::~ChildProcess() {
    closeInput();
    if (m_child > 0) {
        ::kill(m_child, SIGKILL);
        wait();
    }
}

void ChildProcess::closeInput() {
    if (m_input >= 0) {
        ::close(m_input);
        m_input = -1;
    }
}

int ChildProcess::wait() {
    int status = 0;
    while (::waitpid(m_child, &status, 0) < 0 && errno == EINTR) {
    }
    m_child = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string ChildProcess::lastWords() const {
    constexpr long kMost = 400;
    std::string said(kMost, '\0');
    if (std::fseek(m_errors.get(), -kMost, SEEK_END) != 0) {
        std::rewind(m_errors.get()); // it is shorter
    }
    said.resize(std::fread(said.data(), 1, said.size(), m_errors.get()));
    while (!said.empty() && said.back() == '\n') {
        said.pop_back();
    }
    return said;
}

void ChildProcess::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(m_input, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) {
            continue;
        }
        if (sent < 0) {
            closeInput();
            wait(); // so that all it has to say is there
            throw base::RunError(m_name + " ended early: " + lastWords());
        }
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
}

void ChildProcess::finish() {
    closeInput();
    if (const int status = wait(); status != 0) {
        throw base::RunError(m_name + " failed: " + lastWords());
    }
}

bool isInstalled(const std::string& program) {
    try {
        const ChildProcess started({program, "-version"}, {});
    } catch (const base::InputError&) {
        return false;
    }
    return true;
}

std::string shellQuoted(std::string_view word) {
    constexpr std::string_view kHarmless =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
    if (!word.empty() && word.find_first_not_of(kHarmless) == std::string_view::npos) {
        return std::string(word);
    }
    std::string quoted = "'";
    for (const char c : word) {
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return quoted + "'";
}

} // namespace cdr::program
