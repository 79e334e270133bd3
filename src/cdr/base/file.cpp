#include <cdr/base/error.h>
#include <cdr/base/file.h>

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <system_error>

namespace cdr::base {

namespace {

namespace fs = std::filesystem;

/// A name beside `path` that no other process and no other thread of this one uses.
fs::path temporaryBeside(const fs::path& path) {
    static std::atomic<unsigned> counter{0};
    fs::path temporary = path;
    temporary.replace_filename("." + path.stem().string() + "." + std::to_string(::getpid()) + "." +
                               std::to_string(counter++) + path.extension().string());
    return temporary;
}

void writeStream(const fs::path& path, std::span<const std::uint8_t> bytes) {
    std::ofstream stream(path, std::ios::binary);
    if (!stream) {
        const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
        throw InputError(folder.string() + ": cannot create a file in this folder");
    }
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    stream.flush();
    if (!stream) {
        throw RunError(path.string() + ": write failed, is the disk full?");
    }
}

} // namespace

Bytes readFile(const fs::path& path, std::uintmax_t maxBytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (error || !fs::exists(status)) {
        throw InputError(path.string() + ": no such file");
    }
    if (!fs::is_regular_file(status)) {
        throw InputError(path.string() + ": not a regular file");
    }
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) {
        throw InputError(path.string() + ": " + error.message());
    }
    if (size > maxBytes) {
        throw InputError(path.string() + ": " + std::to_string(size) + " bytes is over the limit of " +
                         std::to_string(maxBytes));
    }
    Bytes bytes(static_cast<std::size_t>(size));
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream || static_cast<std::uintmax_t>(stream.gcount()) != size) {
        throw InputError(path.string() + ": cannot be read");
    }
    return bytes;
}

PendingFile::PendingFile(fs::path path) : m_path(std::move(path)), m_temporary(temporaryBeside(m_path)) {
    if (m_path.filename().empty() || fs::is_directory(m_path)) {
        throw InputError(m_path.string() + ": names a folder, not a file to write");
    }
}

PendingFile::~PendingFile() {
    std::error_code ignored;
    fs::remove(m_temporary, ignored);
}

void PendingFile::commit() const {
    std::error_code error;
    fs::rename(m_temporary, m_path, error);
    if (error) {
        throw InputError(m_path.string() + ": cannot be written: " + error.message());
    }
}

void writeBesideThenRename(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const PendingFile file(path);
    write(file.temporary());
    file.commit();
}

void writeFile(const fs::path& path, std::span<const std::uint8_t> bytes) {
    writeBesideThenRename(path, [&](const fs::path& temporary) { writeStream(temporary, bytes); });
}

void writeText(const fs::path& path, std::string_view text) {
    writeFile(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void requireWritable(const fs::path& path) {
    const PendingFile probe(path);
    if (!std::ofstream(probe.temporary(), std::ios::binary)) {
        throw InputError(path.string() + ": cannot be written, its folder is missing or read-only");
    }
}

void makeFolder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) {
        throw InputError(path.string() + ": cannot be made: " + error.message());
    }
}

} // namespace cdr::base
