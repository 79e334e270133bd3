#include "picture_folder.h"

#include <cdr/base/format_error.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <utility>

namespace cdr::cli {

namespace fs = std::filesystem;

void requireFolder(const fs::path& path) {
    std::error_code error;
    fs::path nearest = platform::wholePath(path);
    while (!fs::exists(fs::status(nearest, error)) && nearest.has_relative_path()) {
        nearest = nearest.parent_path();
    }
    if (!fs::is_directory(nearest, error)) {
        throw base::inputError("{}: cannot be made: {} is no folder", path.string(), nearest.string());
    }
    if (::access(nearest.c_str(), W_OK | X_OK) != 0) {
        throw base::inputError("{}: cannot be written: {} is read-only", path.string(), nearest.string());
    }
}

PictureFolder::PictureFolder(fs::path path, CommandFiles& files,
                             const std::function<bool(const std::string&)>& isWritten)
    : m_path(std::move(path)) {
    if (isWanted()) {
        requireFolder(m_path);
        files.writesFolder("--out", m_path, isWritten);
    }
}

std::function<bool(const std::string&)> PictureFolder::oneOf(const std::vector<std::string>& names) {
    std::set<std::string> files;
    for (const std::string& name : names) {
        files.insert(nameInFolder(name));
    }
    return [files](const std::string& name) { return files.contains(name); };
}

std::string PictureFolder::nameInFolder(std::string name) {
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
}

void PictureFolder::write(const std::string& name, const image::ImageRgba8& picture) const {
    if (isWanted()) {
        platform::makeFolder(m_path);
        image::writeImage(m_path / nameInFolder(name), picture);
    }
}

void PictureFolder::write(const char* key, const std::string& name, const image::ImageRgba8& picture,
                          nlohmann::ordered_json& row) const {
    if (isWanted()) {
        write(name, picture);
        row[key] = nameInFolder(name);
    }
}

} // namespace cdr::cli
