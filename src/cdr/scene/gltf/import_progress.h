#pragma once

/// @file
/// @threads Called on the thread that opens the file.
/// @errors None but those that the function names.

#include <cdr/base/export.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <cdr/scene/scene_setup.h>

#include <cstddef>
#include <filesystem>
#include <functional>

namespace cdr::scene {

/// Told how much of a file has been imported: `done` of `all`. They grow with the bytes that are read and the pictures that
/// are decoded. Called about a hundred times.
using ImportProgress = std::function<void(std::size_t done, std::size_t all)>;

/// openGltf() that tells how far it is.
/// @throws base::InputError as openGltf(), and what `progress` throws.
CDR_EXPORT OpenedScene openGltf(const std::filesystem::path& path, const GltfChoice& choice,
                                const ImportProgress& progress);

} // namespace cdr::scene
