#pragma once

#include "accessor.h"
#include "primitive.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cdr::scene::gltf {

/// Corners that a primitive draws, before they are grouped into triangles, lines or points.
std::size_t cornerCount(const Primitive& primitive, Accessors& accessors);

/// The vertices at them. Each index is below `vertexCount`; one that is not is refused.
std::vector<std::uint32_t> cornerList(const Primitive& primitive, Accessors& accessors,
                                      std::size_t vertexCount, const std::string& where);

/// The vertex indices of a primitive as a triangle list; strips and fans are unrolled, a rest that makes no
/// triangle is dropped. Each index is below `vertexCount`; one that is not is refused.
std::vector<std::uint32_t> triangleList(const Primitive& primitive, Accessors& accessors,
                                        std::size_t vertexCount, const std::string& where);

/// Triangles that triangleList() makes of a primitive, from its counts alone: 0 for points and lines.
std::uint64_t triangleCount(const Primitive& primitive, Accessors& accessors);

} // namespace cdr::scene::gltf
