#pragma once

#include "byte_source.h"

#include <cdr/platform/file.h>

#include <optional>
#include <string_view>

namespace cdr::scene::gltf {

/// The parts of a `.gltf` or `.glb` file.
struct Container {
    platform::Bytes json;
    std::optional<ByteSource> bin; ///< the BIN chunk of a GLB, which stays where it is

    std::string_view text() const { return {reinterpret_cast<const char*>(json.data()), json.size()}; }
};

/// Finds the parts; a GLB is told by its first bytes, not by its name.
Container openContainer(const ByteSource& file);

} // namespace cdr::scene::gltf
