#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/input_file.h>
#include <cdr/platform/process.h>
#include <cdr/platform/system_failure.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <system_error>
#include <utility>

namespace cdr::platform {

namespace {

namespace fs = std::filesystem;

constexpr int kMaxLinks = 40; // as Linux has it

/// The descriptor that a name such as /dev/fd/1 or /proc/self/fd/1 stands for.
std::optional<int> descriptorOf(const fs::path& path) {
    const std::string folder = path.parent_path().lexically_normal().string();
    if (folder != "/dev/fd" && folder != "/proc/self/fd" &&
        folder != fmt::format("/proc/{}/fd", processId())) {
        return std::nullopt;
    }
    const std::string name = path.filename().string();
    int descriptor = -1;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), descriptor);
    const bool isNumber = error == std::errc() && end == name.data() + name.size();
    return isNumber && descriptor >= 0 ? std::optional(descriptor) : std::nullopt;
}

/// The path with links followed, up to a name that stands for a descriptor.
fs::path withLinksFollowed(const fs::path& path) {
    fs::path target = path;
    std::error_code error;
    for (int i = 0; i < kMaxLinks; ++i) {
        if (descriptorOf(target) || !fs::is_symlink(fs::symlink_status(target, error))) {
            return target;
        }
        target = target.parent_path() / fs::read_symlink(target, error); // an absolute link replaces the rest
    }
    throw base::InputError(oneLine(path) + ": too many links");
}

/// 64 random bits from the system, in hexadecimal digits.
std::string randomName() {
    std::random_device device;
    return fmt::format("{:08x}{:08x}", device(), device());
}

/// An empty file, or the error number of why there is none.
struct Temporary {
    fs::path path;
    int error = 0;
};

/// With its dot, for writers that choose a format by it. Without one where random names leave no room for it.
std::string shortExtension(const fs::path& path) {
    constexpr std::size_t kMostBytes = 200; // of 255
    std::string extension = path.extension().string();
    return extension.size() > kMostBytes ? std::string() : extension;
}

/// Creates an empty file in `folder` that nobody else has; its mode is what the process' umask leaves.
Temporary createTemporary(const fs::path& folder, const std::string& extension,
                          std::optional<UnfinishedFile>& unfinished) {
    constexpr int kTries = 16;
    int error = EEXIST;
    for (int i = 0; i < kTries; ++i) {
        fs::path temporary = folder / ("." + randomName() + extension);
        unfinished.emplace(temporary);
        const int file =
            ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::close(file);
            return {.path = std::move(temporary)};
        }
        error = errno;
        if (error != EEXIST) {
            break;
        }
    }
    unfinished.reset();
    return {.path = {}, .error = error};
}

/// Writes all bytes to a descriptor; the error number, 0 when it succeeds.
int writeAll(int descriptor, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EAGAIN) { // another program may have made a pipe non-blocking
            ::pollfd room{.fd = descriptor, .events = POLLOUT, .revents = 0};
            ::poll(&room, 1, -1);
        } else if (written < 0 && errno != EINTR) {
            return errno;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return 0;
}

[[noreturn]] void throwWriteFailed(const fs::path& path, int error) {
    throw base::RunError(oneLine(path) + ": write failed: " + std::generic_category().message(error));
}

[[noreturn]] void throwCannotBeWritten(const fs::path& path, int error) {
    throw base::RunError(oneLine(path) + ": cannot be written: " + std::generic_category().message(error));
}

/// An existing file that is open for writing.
class OutputFile {
  public:
    /// @param append of open(): O_APPEND or nothing.
    explicit OutputFile(const fs::path& path, int append = 0)
        : m_descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC | append)),
          m_error(m_descriptor < 0 ? errno : 0) {}
    ~OutputFile() {
        if (m_descriptor >= 0) {
            ::close(m_descriptor);
        }
    }
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes and closes; the error number, 0 when all bytes were written. Some file systems tell of a full disk by close().
    int write(std::span<const std::uint8_t> bytes) {
        if (m_error == 0) {
            m_error = writeAll(m_descriptor, bytes);
        }
        if (m_error == 0 && ::close(std::exchange(m_descriptor, -1)) != 0 && errno != EINTR) {
            m_error = errno;
        }
        return m_error;
    }

  private:
    int m_descriptor;
    int m_error;
};

std::span<const std::uint8_t> bytesOf(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Whether the descriptor is open for writing.
bool isWritable(int descriptor) {
    const int flags = ::fcntl(descriptor, F_GETFL);
    return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

/// Whether `folder` is sticky, as /tmp is, and keeps a file in it for its owner: nobody else can rename another over it.
bool isKeptForItsOwner(const fs::path& file, const fs::path& folder) {
    struct stat ofFile {};
    struct stat ofFolder {};
    const ::uid_t user = ::geteuid();
    return ::lstat(file.c_str(), &ofFile) == 0 && ::stat(folder.c_str(), &ofFolder) == 0 &&
           (ofFolder.st_mode & S_ISVTX) != 0 && user != 0 && user != ofFile.st_uid && user != ofFolder.st_uid;
}

} // namespace

std::string withoutControls(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        // U+0080 to U+009F are controls too: terminals take U+009B for the start of a command.
        if (i > 0 && text[i - 1] == '\xc2' && byte >= 0x80 && byte < 0xa0) {
            text[i - 1] = text[i] = ' ';
        } else if (byte < 0x20 || byte == 0x7f) {
            text[i] = ' ';
        }
    }
    return text;
}

std::string oneLine(const fs::path& path) {
    return withoutControls(path.string());
}

std::optional<FileIdentity> identityOf(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        return std::nullopt;
    }
    return FileIdentity{.device = status.st_dev, .number = status.st_ino};
}

fs::path wholePath(const fs::path& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    fs::path whole = error ? fs::path() : fs::weakly_canonical(absolute, error);
    if (error) {
        throw base::inputError("{}: cannot be found from the current folder: {}", oneLine(path),
                               error.message());
    }
    return whole;
}

Bytes readFile(const fs::path& path, std::uintmax_t maxBytes) {
    const InputFile file(path, maxBytes);
    Bytes bytes(static_cast<std::size_t>(file.size()));
    if (!file.read(0, bytes)) {
        throw base::InputError(oneLine(path) + ": cannot be read");
    }
    return bytes;
}

fs::path scratchPath(const std::string& extension) {
    return fs::temp_directory_path() / (randomName() + extension);
}

PendingFile::PendingFile(fs::path path) : m_path(std::move(path)), m_target(withLinksFollowed(m_path)) {
    std::error_code error;
    const fs::file_status status = fs::status(m_target, error);
    if (m_path.filename().empty() || fs::is_directory(status)) {
        throw base::InputError(oneLine(m_path) + ": names a folder, not a file to write");
    }
    m_descriptor = descriptorOf(m_target);
    m_isCopied = m_descriptor || (fs::exists(status) && !fs::is_regular_file(status));
    if (error == std::errc::filename_too_long) {
        throw base::InputError(oneLine(m_path) + ": cannot be written, its name is too long");
    }
    const bool isRefused =
        m_descriptor ? !isWritable(*m_descriptor) : m_isCopied && ::access(m_target.c_str(), W_OK) != 0;
    if (isRefused) {
        throw base::InputError(oneLine(m_path) + ": cannot be written");
    }
    const fs::path beside = m_target.has_parent_path() ? m_target.parent_path() : ".";
    if (!m_isCopied && fs::exists(status)) { // renaming would replace a read-only file too
        if (::access(m_target.c_str(), W_OK) != 0) {
            throw base::InputError(oneLine(m_path) + ": cannot be written, it is read-only");
        }
        if (isKeptForItsOwner(m_target, beside)) {
            throw base::InputError(oneLine(m_path) +
                                   ": cannot be written, its folder keeps it for its owner alone");
        }
    }
    const fs::path temporaryFolder = m_isCopied ? fs::temp_directory_path(error) : beside;
    if (temporaryFolder.empty()) {
        throw base::InputError(oneLine(m_path) +
                               ": cannot be written, the folder for temporary files is missing");
    }
    Temporary temporary = createTemporary(temporaryFolder, shortExtension(m_path), m_unfinished);
    if (isOfTheSystem(temporary.error)) {
        throwCannotBeWritten(m_path, temporary.error);
    }
    if (temporary.error != 0) {
        throw base::InputError(oneLine(m_path) + ": cannot be written, its folder is missing or read-only");
    }
    m_temporary = std::move(temporary.path);
    if (fs::is_regular_file(status)) {
        fs::permissions(m_temporary, status.permissions(), error);
    }
}

PendingFile::~PendingFile() {
    std::error_code ignored;
    fs::remove(m_temporary, ignored);
}

void PendingFile::commit() const {
    if (m_isCopied) {
        const Bytes bytes = readFile(m_temporary, std::numeric_limits<std::uintmax_t>::max());
        std::fflush(stdout); // what was printed before comes first
        const int error = m_descriptor ? writeAll(*m_descriptor, bytes) : OutputFile(m_target).write(bytes);
        if (error != 0) {
            throwWriteFailed(m_path, error);
        }
        return;
    }
    std::error_code error;
    fs::rename(m_temporary, m_target, error);
    if (error) {
        throwCannotBeWritten(m_path, error.value());
    }
}

void writeBesideThenRename(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const PendingFile file(path);
    write(file.temporary());
    file.commit();
}

void writeFile(const fs::path& path, std::span<const std::uint8_t> bytes) {
    writeBesideThenRename(path, [&](const fs::path& temporary) {
        if (const int error = OutputFile(temporary).write(bytes); error != 0) {
            throwWriteFailed(path, error);
        }
    });
}

void writeText(const fs::path& path, std::string_view text) {
    writeFile(path, bytesOf(text));
}

void appendText(const fs::path& path, std::string_view text) {
    if (const int error = OutputFile(path, O_APPEND).write(bytesOf(text)); error != 0) {
        throwWriteFailed(path, error);
    }
}

void requireWritable(const fs::path& path) {
    const PendingFile probe(path);
}

std::string lowerExtension(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void makeFolder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) {
        const std::string message = oneLine(path) + ": cannot be made: " + error.message();
        if (isOfTheSystem(error.value())) {
            throw base::RunError(message);
        }
        throw base::InputError(message);
    }
}

} // namespace cdr::platform
