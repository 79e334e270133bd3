#pragma once

#include <filesystem>
#include <string>

namespace cdr::output {

/// Checks that another program has written all of a file. Some end with status 0 although the disk was full.
/// @param written the file, a .png, .svg or .mp4.
/// @param name what messages call it. base::RunError when it has no end. That is a PNG's last chunk, an
/// SVG's closing tag, all boxes of an MP4.
void requireWhole(const std::filesystem::path& written, const std::filesystem::path& name,
                  const std::string& program);

} // namespace cdr::output
