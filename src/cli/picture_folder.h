#pragma once

#include "command_files.h"

#include <cdr/image/image.h>

#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace cdr::cli {

/// base::InputError unless the folder can be made, or is there and can be written.
void requireFolder(const std::filesystem::path& path);

/// The folder that a command writes pictures into, if it was asked to. It is made with the first picture.
class PictureFolder {
  public:
    /// @param path of --out; none when empty.
    /// @param files of the command, which none of the pictures may replace.
    /// @param isWritten whether a file may be one of the pictures, by its name.
    /// base::InputError when pictures cannot be written there.
    PictureFolder(std::filesystem::path path, CommandFiles& files,
                  const std::function<bool(const std::string& name)>& isWritten);

    /// Whether a file is one of those that write() makes of these names.
    static std::function<bool(const std::string& name)> oneOf(const std::vector<std::string>& names);
    /// The same, of what has one picture each.
    template <typename List, typename NameOf>
    static std::function<bool(const std::string& name)> oneOf(const List& list, const NameOf& nameOf) {
        std::vector<std::string> names;
        std::ranges::transform(list, std::back_inserter(names), nameOf);
        return oneOf(names);
    }

    bool isWanted() const { return !m_path.empty(); }
    const std::filesystem::path& path() const { return m_path; }

    /// What a picture's file is called. A slash becomes a dash: names of techniques, such as "standard/count:3", are parts of
    /// the names of pictures.
    static std::string nameInFolder(std::string name);

    /// Writes a picture, if the folder is wanted, as nameInFolder() calls it.
    void write(const std::string& name, const image::ImageRgba8& picture) const;
    /// The same, and its name as a field of a row.
    void write(const char* key, const std::string& name, const image::ImageRgba8& picture,
               nlohmann::ordered_json& row) const;

  private:
    std::filesystem::path m_path;
};

} // namespace cdr::cli
