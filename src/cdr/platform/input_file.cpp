#include <cdr/base/error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/input_file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace cdr::platform {

namespace {

namespace fs = std::filesystem;

/// What is no regular file is not opened: that may wait, or do something.
void requireRegularFile(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) {
        throw base::InputError(oneLine(path) + ": no such file");
    }
    if (error) {
        throw base::InputError(oneLine(path) + ": " + error.message());
    }
    if (!fs::is_regular_file(status)) {
        throw base::InputError(oneLine(path) + ": not a regular file");
    }
}

/// Of an open regular file; nothing of what is none.
bool sizeOf(int descriptor, std::uintmax_t& size) {
    struct stat status {};
    if (descriptor < 0 || ::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
        return false;
    }
    size = static_cast<std::uintmax_t>(status.st_size);
    return true;
}

} // namespace

InputFile::InputFile(const fs::path& path, std::uintmax_t maxBytes) {
    requireRegularFile(path);
    // It may be another file by now, which must not be waited for.
    m_descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const bool isReadable = sizeOf(m_descriptor, m_size);
    if (isReadable && m_size <= maxBytes) {
        return;
    }
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
    }
    throw base::InputError(
        isReadable ? fmt::format("{}: {} bytes is over the limit of {}", oneLine(path), m_size, maxBytes)
                   : oneLine(path) + ": cannot be read");
}

InputFile::~InputFile() {
    ::close(m_descriptor);
}

bool InputFile::read(std::uintmax_t offset, std::span<std::uint8_t> bytes) const {
    while (!bytes.empty()) {
        const ssize_t count = ::pread(m_descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (count == 0 || (count < 0 && errno != EINTR)) {
            return false;
        }
        if (count > 0) {
            offset += static_cast<std::uintmax_t>(count);
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        }
    }
    return true;
}

} // namespace cdr::platform
