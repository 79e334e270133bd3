#pragma once

#include "accessor.h"
#include "primitive.h"

#include <cstdint>
#include <string>

namespace cdr::scene::gltf {

/// Bytes that a primitive takes, predicted from the counts of its accessors.
struct PrimitiveBytes {
    std::uint64_t kept = 0;    ///< in the scene
    std::uint64_t passing = 0; ///< besides, while it is imported
};

/// Whether vertices may need scene::VertexDetail beside themselves.
enum class VertexKind : std::uint8_t { plain, detailed };

/// What importing a primitive takes at most, except for the rows of triangles that pieces share at their seams.
/// A small file can name large counts: elements without bytes are zeros, and repeated indices take bytes for
/// each vertex that they name.
PrimitiveBytes predictBytes(const Primitive& primitive, Accessors& accessors, VertexKind kind);

/// Adds up what an import is about to take, and refuses what would go over the limit.
class MemoryPrediction {
  public:
    /// @param limit bytes
    explicit MemoryPrediction(std::uint64_t limit);

    /// `where` names the primitive in the message.
    void add(const PrimitiveBytes& bytes, const std::string& where);
    /// Bytes that add() was told of and that are free again.
    void release(std::uint64_t bytes) { m_kept -= bytes; }
    /// Bytes up to the limit.
    std::uint64_t left() const { return m_limit - m_kept; }
    /// Bytes that are free below the limit while a primitive that add() was told of is imported. What is optional may use
    /// them.
    std::uint64_t leftBeside(const PrimitiveBytes& bytes) const;
    /// Instances: what places a primitive in the world. `what` names them in the message.
    void addInstances(std::uint64_t count, const std::string& what);

  private:
    void require(std::uint64_t passing, const std::string& what) const;

    std::uint64_t m_limit;
    std::uint64_t m_kept = 0;
};

} // namespace cdr::scene::gltf
