#pragma once

#include <cdr/scene/gltf/gltf.h>

#include <ranks/ranks.h>

#include <string>
#include <vector>

namespace cdr::runs {

/// base::InputError on the first rank, naming rank and file, unless all ranks read the same bytes. A rank with another
/// scene would make wrong pictures, or wait for a frame that no rank draws. A process that is alone reads nothing.
/// @param what has these files, for the message.
/// @param files by URI; they may be missing, if on all ranks.
void requireSameFiles(ranks::Run& ranks, const std::string& what,
                      const std::vector<scene::GltfReference>& files);

/// A SHA-256 of those bytes. A file that cannot be read counts as such.
std::string digestOfFiles(const std::vector<scene::GltfReference>& files);

} // namespace cdr::runs
