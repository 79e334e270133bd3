#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace cdr::scene::gltf {

/// The parts of a `.gltf` or `.glb` file; views of its bytes.
struct Container {
    std::string_view json;
    std::optional<std::span<const std::uint8_t>> bin; ///< the BIN chunk of a GLB
};

/// Finds the parts; a GLB is told by its first bytes, not by its name.
Container openContainer(std::span<const std::uint8_t> file);

} // namespace cdr::scene::gltf
