#pragma once

#include <cdr/platform/file.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace cdr::scene::gltf {

inline constexpr const char* kMeshopt = "EXT_meshopt_compression";

/// What EXT_meshopt_compression says of a buffer view, checked against its specification.
struct MeshoptView {
    enum class Mode { attributes, triangles, indices };
    enum class Filter { none, octahedral, quaternion, exponential };

    int buffer = 0; ///< that holds the compressed bytes
    std::size_t offset = 0;
    std::size_t length = 0;
    std::size_t stride = 0; ///< bytes of an element
    std::size_t count = 0;  ///< of elements
    Mode mode = Mode::attributes;
    Filter filter = Filter::none;
};

/// Refuses what the specification does not allow.
/// @param bytes of the view once it is decoded.
MeshoptView readMeshoptView(const nlohmann::json& extension, std::size_t bytes, const std::string& where);

/// The bytes of a view. Refuses compressed ones that are not sound.
platform::Bytes decodeMeshopt(const MeshoptView& view, std::span<const std::uint8_t> compressed,
                              const std::string& where);

} // namespace cdr::scene::gltf
