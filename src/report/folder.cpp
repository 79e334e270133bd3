#include "folder.h"

#include "manifest.h"
#include "mount_point.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/process.h>
#include <cdr/platform/system_failure.h>

#include <fmt/format.h>
#include <program/sha256.h>

#include <algorithm>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace cdr::report {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxManifestBytes = 10'000'000;

/// The files that a report's manifest calls its own. base::InputError when there is no sound manifest.
std::set<std::string> ownFiles(const fs::path& folder) {
    const fs::path manifest = folder / kManifest;
    if (fs::is_regular_file(manifest)) {
        const platform::Bytes bytes = platform::readFile(manifest, kMaxManifestBytes);
        if (auto files = filesOfManifest({reinterpret_cast<const char*>(bytes.data()), bytes.size()})) {
            return *std::move(files);
        }
    }
    throw base::inputError("{}: is neither empty nor a report, so it is not replaced", folder.string());
}

/// What lies in a folder, without one name.
std::vector<fs::path> entriesOf(const fs::path& folder, const fs::path& except) {
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path() != except) {
            entries.push_back(entry.path());
        }
    }
    return entries;
}

/// base::InputError unless a report may stand there.
/// @param except a folder in it that does not count.
void requireReplaceable(const fs::path& folder, const fs::path& except) {
    if (!fs::exists(folder)) {
        return;
    }
    if (!fs::is_directory(folder)) {
        throw base::inputError("{}: is a file, and a report needs a folder", folder.string());
    }
    if (entriesOf(folder, except).empty()) {
        return;
    }
    const std::set<std::string> own = ownFiles(folder);
    const std::string skipped = except.filename().generic_string() + "/";
    for (const fs::path& file : filesUnder(folder)) {
        const std::string name = file.generic_string();
        if (!own.contains(name) && (except.empty() || !name.starts_with(skipped))) {
            throw base::inputError("{}: holds {}, which is not the report's; move it away first",
                                   folder.string(), file.string());
        }
    }
}

/// With links followed and no slash at the end, so that what stands beside it is a name with a suffix.
fs::path resolved(const fs::path& path) {
    fs::path whole = platform::wholePath(path);
    if (whole.filename().empty()) {
        whole = whole.parent_path();
    }
    if (whole.filename().empty()) {
        throw base::inputError("{}: cannot be the folder of a report", path.string());
    }
    return whole;
}

/// A hidden name in `folder`.
fs::path hiddenIn(const fs::path& folder, const fs::path& path, std::string_view whose,
                  std::string_view what) {
    return folder / fmt::format(".{}.{}.{}", path.filename().string(), whose, what);
}

/// A hidden name in `folder` that no other process uses.
fs::path hiddenIn(const fs::path& folder, const fs::path& path, std::string_view what) {
    return hiddenIn(folder, path, std::to_string(platform::processId()), what);
}

/// Copies the files of a report, which has none but its own.
void copyFiles(const fs::path& report, const fs::path& to) {
    for (const fs::path& file : filesUnder(report)) {
        if (fs::is_regular_file(report / file)) {
            fs::create_directories((to / file).parent_path());
            fs::copy_file(report / file, to / file);
        }
    }
}

/// Whether the current folder is `path`. base::InputError when it lies deeper in it: it would be removed.
bool isCurrent(const fs::path& path) {
    std::error_code error;
    const fs::path current = fs::canonical(fs::current_path(error), error);
    const fs::path inside = current.lexically_relative(path);
    if (!error && !inside.empty() && inside != "." && *inside.begin() != "..") {
        throw base::inputError("{}: the current folder lies in it", path.string());
    }
    return !error && inside == ".";
}

/// Renames entries into another folder; when one fails, the others go back.
void moveAll(const std::vector<fs::path>& entries, const fs::path& to, std::error_code& error) {
    std::vector<fs::path> moved;
    for (const fs::path& entry : entries) {
        fs::rename(entry, to / entry.filename(), error);
        if (error) {
            std::error_code ignored;
            for (const fs::path& back : moved) {
                fs::rename(to / back.filename(), back, ignored);
            }
            return;
        }
        moved.push_back(entry);
    }
}

[[noreturn]] void throwNotInPlace(const fs::path& path, const std::error_code& error) {
    throw base::runError("{}: cannot be written: {}", path.string(), error.message());
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

PendingFolder::PendingFolder(const fs::path& path, const std::string& state) : m_path(resolved(path)) {
    const std::string kept = state.empty() ? "" : program::sha256Of(state).substr(0, 12);
    requireReplaceable(m_path, state.empty() ? fs::path() : hiddenIn(m_path, m_path, kept, "new"));
    m_isInside = fs::exists(m_path) && (isCurrent(m_path) || isMountPoint(m_path));
    const fs::path folder = m_isInside ? m_path : m_path.parent_path();
    m_temporary = state.empty() ? hiddenIn(folder, m_path, "new") : hiddenIn(folder, m_path, kept, "new");
    if (state.empty()) {
        makeTemporary(folder);
    } else {
        continueEarlier(folder);
    }
}

void PendingFolder::makeTemporary(const fs::path& folder) const {
    std::error_code error;
    if (!fs::create_directory(m_temporary, error)) {
        const std::string why = error ? error.message() : m_temporary.filename().string() + " is in the way";
        const std::string message = fmt::format("{}: no folder can be made here: {}", folder.string(), why);
        if (platform::isOfTheSystem(error.value())) {
            throw base::RunError(message);
        }
        throw base::InputError(message);
    }
}

void PendingFolder::continueEarlier(const fs::path& folder) {
    if (fs::is_directory(fs::symlink_status(m_temporary))) {
        m_isKept = true;
        return;
    }
    makeTemporary(folder);
    if (fs::is_regular_file(m_path / kManifest)) {
        try {
            copyFiles(m_path, m_temporary);
        } catch (...) { // no destructor will remove what was copied
            std::error_code ignored;
            fs::remove_all(m_temporary, ignored);
            throw;
        }
    }
}

PendingFolder::~PendingFolder() {
    if (!m_isKept) {
        std::error_code ignored;
        fs::remove_all(m_temporary, ignored);
    }
}

void PendingFolder::commit() {
    requireReplaceable(m_path, m_isInside ? m_temporary : fs::path()); // hours may have passed
    if (m_isInside) {
        moveIntoPlace();
    } else {
        renameIntoPlace();
    }
    m_isKept = false; // what the temporary folder is not any more
}

void PendingFolder::renameIntoPlace() const {
    const fs::path old = hiddenIn(m_path.parent_path(), m_path, "old");
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
        throwNotInPlace(m_path, error);
    }
    fs::remove_all(old, error);
}

void PendingFolder::moveIntoPlace() const {
    const fs::path old = hiddenIn(m_path, m_path, "old");
    const std::vector<fs::path> replaced = entriesOf(m_path, m_temporary);
    std::error_code error;
    fs::create_directory(old, error);
    if (!error) {
        moveAll(replaced, old, error);
    }
    if (!error) {
        moveAll(entriesOf(m_temporary, {}), m_path, error);
        if (error) {
            std::error_code ignored;
            moveAll(entriesOf(old, {}), m_path, ignored);
        }
    }
    if (error) {
        std::error_code ignored;
        fs::remove(old, ignored); // where it is empty
        throwNotInPlace(m_path, error);
    }
    fs::remove_all(old, error);
    fs::remove(m_temporary, error);
}

} // namespace cdr::report
