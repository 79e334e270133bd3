// A library that makes one call on files fail, to be put before the system's with LD_PRELOAD.
//
// The environment variable CDR_FILE_FAULT chooses it: "AFTER ERROR", for instance "5 28". Calls are counted that open a file
// to write, write into one, close one, rename one or make a folder. Only those in the folder that the process starts in count.
// The call after the first AFTER fails with ERROR, an errno. A file whose close fails is closed, and
// as it was when it was opened: what was written did not reach the disk.
//
// The environment variable CDR_FILE_FAULT_LOG names a file. When the process ends, the number of calls is added to it, a line.
//
// Where CDR_AFFINITY_FAULT is set, no process is bound to CPUs any more.

#include <climits>
#include <dlfcn.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace {

template <typename Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

class FileFault {
  public:
    FileFault() {
        const char* text = std::getenv("CDR_FILE_FAULT");
        if (text == nullptr || std::sscanf(text, "%ld %d", &m_after, &m_error) != 2 ||
            ::getcwd(m_folder.data(), m_folder.size()) == nullptr) {
            m_folder[0] = '\0';
        }
    }
    ~FileFault() {
        const char* log = std::getenv("CDR_FILE_FAULT_LOG");
        if (log == nullptr || m_folder[0] == '\0') {
            return;
        }
        std::FILE* file = next<std::FILE* (*)(const char*, const char*)>("fopen")(log, "a");
        if (file != nullptr) {
            std::fprintf(file, "%ld\n", m_calls.load());
            next<int (*)(std::FILE*)>("fclose")(file);
        }
    }
    FileFault(const FileFault&) = delete;
    FileFault& operator=(const FileFault&) = delete;

    /// Counts a call on a path. True, with errno set, when it must fail.
    bool hits(const char* path) { return isInside(path) && hits(); }
    bool hits(int descriptor) { return isOurs(descriptor) && hits(); }

    /// Remembers what was opened to write, and how long it was.
    int opened(const char* path, int descriptor) {
        if (descriptor >= 0 && descriptor < kDescriptors) {
            struct stat status {};
            const bool isKnown = isInside(path) && ::fstat(descriptor, &status) == 0;
            m_ours[static_cast<std::size_t>(descriptor)] = isKnown;
            m_sizes[static_cast<std::size_t>(descriptor)] = status.st_size;
        }
        return descriptor;
    }

    /// What was written since did not reach the disk.
    void loseBytes(int descriptor) {
        if (::ftruncate(descriptor, m_sizes[static_cast<std::size_t>(descriptor)]) != 0) {
            std::abort();
        }
    }

  private:
    static constexpr int kDescriptors = 1024;

    bool hits() {
        if (m_calls++ != m_after) {
            return false;
        }
        errno = m_error;
        return true;
    }
    bool isInside(const char* path) const {
        const std::string_view folder(m_folder.data());
        return !folder.empty() && (path[0] != '/' || std::string_view(path).starts_with(folder));
    }
    bool isOurs(int descriptor) const {
        return descriptor >= 0 && descriptor < kDescriptors && m_ours[static_cast<std::size_t>(descriptor)];
    }

    std::array<char, PATH_MAX> m_folder{};
    std::array<std::atomic<bool>, kDescriptors> m_ours{};
    std::array<std::atomic<off_t>, kDescriptors> m_sizes{};
    long m_after = 0;
    int m_error = 0;
    std::atomic<long> m_calls{0};
};

FileFault& fileFault() {
    static FileFault only;
    return only;
}

using Open = int (*)(const char*, int, ...);

int openWith(const char* name, const char* path, int flags, mode_t mode) {
    const bool isWritten = (flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0;
    if (isWritten && fileFault().hits(path)) {
        return -1;
    }
    const int descriptor = next<Open>(name)(path, flags, mode);
    return isWritten ? fileFault().opened(path, descriptor) : descriptor;
}

std::FILE* openStream(const char* name, const char* path, const char* mode) {
    const bool isWritten = std::strpbrk(mode, "wa+") != nullptr;
    if (isWritten && fileFault().hits(path)) {
        return nullptr;
    }
    std::FILE* file = next<std::FILE* (*)(const char*, const char*)>(name)(path, mode);
    if (isWritten && file != nullptr) {
        fileFault().opened(path, ::fileno(file));
    }
    return file;
}

mode_t modeOf(int flags, std::va_list& rest) {
    return (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
}

} // namespace

#define CDR_EXPORT extern "C" __attribute__((visibility("default")))

CDR_EXPORT int open(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = modeOf(flags, rest);
    va_end(rest);
    return openWith("open", path, flags, mode);
}

CDR_EXPORT int open64(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = modeOf(flags, rest);
    va_end(rest);
    return openWith("open64", path, flags, mode);
}

CDR_EXPORT std::FILE* fopen(const char* path, const char* mode) {
    return openStream("fopen", path, mode);
}

CDR_EXPORT std::FILE* fopen64(const char* path, const char* mode) {
    return openStream("fopen64", path, mode);
}

CDR_EXPORT ssize_t write(int descriptor, const void* bytes, std::size_t count) {
    return fileFault().hits(descriptor)
               ? -1
               : next<ssize_t (*)(int, const void*, std::size_t)>("write")(descriptor, bytes, count);
}

CDR_EXPORT ssize_t writev(int descriptor, const iovec* parts, int count) {
    return fileFault().hits(descriptor)
               ? -1
               : next<ssize_t (*)(int, const iovec*, int)>("writev")(descriptor, parts, count);
}

CDR_EXPORT int close(int descriptor) {
    const bool isHit = fileFault().hits(descriptor);
    const int error = errno;
    if (isHit) {
        fileFault().loseBytes(descriptor);
    }
    fileFault().opened("/", descriptor); // the number may come again
    const int closed = next<int (*)(int)>("close")(descriptor);
    errno = isHit ? error : errno;
    return isHit ? -1 : closed;
}

CDR_EXPORT int fclose(std::FILE* file) {
    const int descriptor = ::fileno(file);
    const bool isHit = fileFault().hits(descriptor);
    const int error = errno;
    std::fflush(file);
    if (isHit) {
        fileFault().loseBytes(descriptor);
    }
    fileFault().opened("/", descriptor);
    const int closed = next<int (*)(std::FILE*)>("fclose")(file);
    errno = isHit ? error : errno;
    return isHit ? EOF : closed;
}

CDR_EXPORT int rename(const char* from, const char* to) noexcept {
    return fileFault().hits(to) ? -1 : next<int (*)(const char*, const char*)>("rename")(from, to);
}

CDR_EXPORT int mkdir(const char* path, mode_t mode) noexcept {
    return fileFault().hits(path) ? -1 : next<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}

CDR_EXPORT int sched_setaffinity(pid_t process, std::size_t size, const cpu_set_t* set) noexcept {
    if (std::getenv("CDR_AFFINITY_FAULT") != nullptr) {
        errno = EINVAL;
        return -1;
    }
    return next<int (*)(pid_t, std::size_t, const cpu_set_t*)>("sched_setaffinity")(process, size, set);
}
