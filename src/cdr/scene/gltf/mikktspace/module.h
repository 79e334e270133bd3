#pragma once

#include <cdr/base/result.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace cdr::scene::gltf {

/// A corner of a triangle, as MikkTSpace takes it.
struct TangentCorner {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f}; ///< unit length
    glm::vec2 uv{0.0f};     ///< as in the file: v grows down the texture
};

/// What one call may take.
struct MikkTSpaceLimits {
    std::uint64_t bytes;         ///< of memory, at most 4 GiB
    std::uint32_t depth = 2'500; ///< of nested calls: each takes about 0.2 KiB of the thread's stack
};

/// Whether cdr was built with the library, which third_party/mikktspace.sh fetches.
bool hasMikkTSpace();

/// Bytes that a call takes at most, its result included.
/// @param corners below 2^48.
std::uint64_t mikkTSpaceBytes(std::uint64_t corners);

/// The tangents of triangles by MikkTSpace, in the order of corners. Each is the direction in which u grows, and 1 or -1
/// as VertexDetail::tangent has it. Equal corners count as one vertex. Where the texture coordinates of a corner's
/// triangles are flattened, its direction may be any. The time grows with the square of the triangles that meet at a
/// vertex, and of those whose corners do not differ in position. A refusal says why there are none: the library is not
/// there, it would go beyond a limit, or it failed.
/// @param corners a multiple of three. @param cornerAt the one of a number below `corners`, finite.
/// @threads Any number at once: each call has a state of its own.
base::Result<std::vector<glm::vec4>> mikkTSpace(std::size_t corners,
                                                const std::function<TangentCorner(std::size_t)>& cornerAt,
                                                const MikkTSpaceLimits& limits);

} // namespace cdr::scene::gltf
