#pragma once

#include "bytes/byte_source.h"

#include <cdr/scene/gltf/gltf.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace cdr::scene::gltf {

/// loadGltf() of bytes in memory or in a file. `path` is where they come from, and starts messages. The folder of a file holds
/// the files that it refers to. What is read of them more than once may have changed, which is refused or harmless.
GltfImport importGltf(const ByteSource& file, const std::filesystem::path& path, const GltfLimits& limits,
                      std::optional<std::uint32_t> scene = {});

} // namespace cdr::scene::gltf
