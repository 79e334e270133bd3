#include "gnuplot.h"

#include <cdr/base/error.h>
#include <cdr/base/file.h>
#include <cdr/base/suggest.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

namespace cdr::experiments {

namespace {

constexpr int kNotFound = 127;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
/// A file without a name, gone when closed.
using AnonymousFile = std::unique_ptr<std::FILE, CloseFile>;

AnonymousFile makeAnonymousFile(const std::string& content) {
    AnonymousFile file(std::tmpfile());
    if (!file || std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() ||
        std::fflush(file.get()) != 0) {
        throw base::RunError(fmt::format("a temporary file cannot be made: {}", std::strerror(errno)));
    }
    std::rewind(file.get());
    return file;
}

/// What a child process reads and writes instead of ours.
class FileActions {
  public:
    FileActions() { posix_spawn_file_actions_init(&m_actions); }
    ~FileActions() { posix_spawn_file_actions_destroy(&m_actions); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    void redirect(int from, int to) { posix_spawn_file_actions_adddup2(&m_actions, from, to); }
    void redirectToNew(const char* path, int to) {
        posix_spawn_file_actions_addopen(&m_actions, to, path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    }
    const posix_spawn_file_actions_t* get() const { return &m_actions; }

  private:
    posix_spawn_file_actions_t m_actions{};
};

/// Exit status of gnuplot, kNotFound where it is not installed.
int runGnuplot(std::vector<std::string> arguments, const FileActions& actions) {
    arguments.insert(arguments.begin(), "gnuplot");
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    pid_t child = 0;
    if (::posix_spawnp(&child, argv[0], actions.get(), nullptr, argv.data(), environ) != 0) {
        return kNotFound;
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool isPng(const std::filesystem::path& path) {
    return path.extension() == ".png";
}

} // namespace

void requirePlottable(const std::filesystem::path& path) {
    constexpr std::array<std::string_view, 2> kExtensions{".png", ".svg"};
    const std::string extension = path.extension().string();
    if (std::find(kExtensions.begin(), kExtensions.end(), extension) == kExtensions.end()) {
        throw base::InputError(base::unknownName("plot format", extension, kExtensions));
    }
    base::requireWritable(path);
    FileActions silent;
    silent.redirectToNew("/dev/null", STDOUT_FILENO);
    silent.redirectToNew("/dev/null", STDERR_FILENO);
    if (runGnuplot({"--version"}, silent) != 0) {
        throw base::InputError("plots need gnuplot, which is not installed (Debian, Ubuntu: gnuplot-nox)");
    }
}

void writePlot(const std::filesystem::path& path, const std::string& script) {
    const char* terminal = isPng(path) ? "set terminal pngcairo noenhanced size 1200,700 font 'sans,11'\n"
                                       : "set terminal svg noenhanced size 1200,700 font 'sans,14' "
                                         "background 'white'\n";
    const AnonymousFile input = makeAnonymousFile(terminal + script);
    const AnonymousFile errors = makeAnonymousFile("");
    base::writeBesideThenRename(path, [&](const std::filesystem::path& temporary) {
        FileActions actions;
        actions.redirect(::fileno(input.get()), STDIN_FILENO);
        actions.redirectToNew(temporary.c_str(), STDOUT_FILENO);
        actions.redirect(::fileno(errors.get()), STDERR_FILENO);
        // -d: nobody's own start-up file has a say.
        if (runGnuplot({"-d", "-"}, actions) != 0) {
            std::string said(400, '\0');
            std::rewind(errors.get());
            said.resize(std::fread(said.data(), 1, said.size(), errors.get()));
            throw base::RunError(fmt::format("{}: gnuplot failed: {}", path.string(), said));
        }
    });
}

std::string gnuplotQuote(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'') {
            quoted += "''"; // as gnuplot writes a quote within quotes
        } else {
            quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return quoted + "'";
}

} // namespace cdr::experiments
