#pragma once

#include "bytes/byte_source.h"

#include <cdr/scene/gltf/gltf.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace cdr::scene::gltf {

/// loadGltf() of bytes that are already in memory. `path` is where they come from: its folder holds the files
/// they refer to, and its name starts messages.
GltfImport importGltf(std::span<const std::uint8_t> file, const std::filesystem::path& path,
                      const GltfLimits& limits, std::optional<std::uint32_t> scene = {});

/// The same of bytes that may be in a file. What is read of them more than once may have changed, which is refused or harmless.
GltfImport importGltf(const ByteSource& file, const std::filesystem::path& path, const GltfLimits& limits,
                      std::optional<std::uint32_t> scene = {});

} // namespace cdr::scene::gltf
