#pragma once

#include <ranks/ranks.h>

#include <filesystem>
#include <string>

namespace cdr::runs {

// Each: base::InputError on the first rank, naming rank and file, unless all ranks read the same bytes. A rank with another
// scene would make wrong pictures, or wait for a frame that no rank draws. A process that is alone reads nothing.

/// Of the file, and where it is glTF, of the files that it refers to; those may be missing, if on all ranks.
void requireSameFiles(ranks::Ranks& ranks, const std::filesystem::path& path);

/// Of the pictures in that folder which the scene orbit shows; they may be missing, if on all ranks.
void requireSameEarth(ranks::Ranks& ranks, const std::filesystem::path& folder);

// Each: a SHA-256 of the same bytes. A file that cannot be read counts as such.

std::string digestOfFiles(const std::filesystem::path& path);
std::string digestOfEarth(const std::filesystem::path& folder);

} // namespace cdr::runs
