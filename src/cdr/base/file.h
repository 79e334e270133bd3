#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace cdr::base {

using Bytes = std::vector<std::uint8_t>;

/// Reads a whole regular file. InputError when it is missing, not a regular file, or larger than `maxBytes`.
Bytes readFile(const std::filesystem::path& path, std::uintmax_t maxBytes);

/// Lets `write` fill a temporary file beside `path`, then renames it over `path`: either the whole file
/// appears or nothing does. InputError when the folder is missing or not writable; whatever `write` throws
/// passes through.
void writeBesideThenRename(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

/// writeBesideThenRename() of bytes in memory.
void writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// writeFile() of a text as it is.
void writeText(const std::filesystem::path& path, std::string_view text);

/// InputError unless a file can be created at `path`. Leaves nothing behind; call before long work.
void requireWritable(const std::filesystem::path& path);

} // namespace cdr::base
