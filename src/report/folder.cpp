#include "folder.h"

#include <cdr/base/error.h>
#include <cdr/host/file.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <system_error>

namespace cdr::report {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxManifestBytes = 10'000'000;

/// The files that a report's manifest calls its own. base::InputError when there is no sound manifest.
std::set<std::string> ownFiles(const fs::path& folder) {
    const fs::path manifest = folder / kManifest;
    if (fs::is_regular_file(manifest)) {
        const host::Bytes bytes = host::readFile(manifest, kMaxManifestBytes);
        const auto json = nlohmann::json::parse(bytes, nullptr, false);
        if (json.is_object() && json.value("command", nlohmann::json()) == "report" &&
            json.contains("files") && json.at("files").is_array()) {
            std::set<std::string> files{kManifest};
            for (const auto& file : json.at("files")) {
                if (file.is_string()) {
                    files.insert(file.get<std::string>());
                }
            }
            return files;
        }
    }
    throw base::InputError(
        fmt::format("{}: not empty and not a report, so it is left as it is", folder.string()));
}

/// With links followed and no slash at the end, so that what stands beside it is a name with a suffix.
fs::path resolved(const fs::path& path) {
    std::error_code error;
    fs::path whole = fs::weakly_canonical(fs::absolute(path), error);
    if (whole.filename().empty()) {
        whole = whole.parent_path();
    }
    if (error || whole.filename().empty()) {
        throw base::InputError(fmt::format("{}: cannot hold a report", path.string()));
    }
    return whole;
}

/// A name beside `path` that no other process uses.
fs::path beside(const fs::path& path, std::string_view what) {
    return path.parent_path() /
           fmt::format(".{}.{}.{}", path.filename().string(), static_cast<long>(::getpid()), what);
}

} // namespace

std::vector<fs::path> filesUnder(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_directory() || entry.is_symlink()) {
            files.push_back(entry.path().lexically_relative(folder));
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

void requireReplaceable(const fs::path& path) {
    const fs::path folder = resolved(path);
    if (!fs::exists(folder)) {
        return;
    }
    if (!fs::is_directory(folder)) {
        throw base::InputError(fmt::format("{}: a file, where the report's folder is to be", path.string()));
    }
    if (fs::is_empty(folder)) {
        return;
    }
    const std::set<std::string> own = ownFiles(folder);
    for (const fs::path& file : filesUnder(folder)) {
        if (!own.contains(file.generic_string())) {
            throw base::InputError(fmt::format("{}: holds {}, which is not the report's; move it away first",
                                               folder.string(), file.string()));
        }
    }
}

PendingFolder::PendingFolder(const fs::path& path) : m_path(resolved(path)) {
    requireReplaceable(m_path);
    m_temporary = beside(m_path, "new");
    std::error_code error;
    if (!fs::create_directory(m_temporary, error)) {
        throw base::InputError(
            fmt::format("{}: no folder can be made here: {}", m_path.parent_path().string(),
                        error ? error.message() : m_temporary.filename().string() + " is in the way"));
    }
}

PendingFolder::~PendingFolder() {
    std::error_code ignored;
    fs::remove_all(m_temporary, ignored);
}

void PendingFolder::commit() const {
    requireReplaceable(m_path); // hours may have passed
    const fs::path old = beside(m_path, "old");
    std::error_code error;
    if (fs::exists(m_path)) {
        fs::rename(m_path, old, error);
    }
    if (!error) {
        fs::rename(m_temporary, m_path, error);
        if (error && fs::exists(old)) {
            std::error_code ignored;
            fs::rename(old, m_path, ignored);
        }
    }
    if (error) {
        throw base::InputError(fmt::format("{}: cannot be written: {}", m_path.string(), error.message()));
    }
    fs::remove_all(old, error);
}

} // namespace cdr::report
