#pragma once

#include <cdr/depth/cascade.h>
#include <cdr/scene/frustum.h>
#include <cdr/visibility/half_space.h>
#include <cdr/visibility/mesh_chunks.h>

#include <glm/glm.hpp>

#include <array>

namespace cdr::visibility {

/// What a cascade shows of large meshes. What it leaves out covers no pixel there, wherever the device rounds vertices to.
class ChunkTest {
  public:
    /// @param clipRange of the cascade. @param anchorView of its depth::ClipTerms.
    ChunkTest(const scene::Camera& camera, const scene::Frustum& frustum, const depth::Cascade& clipRange,
              double anchorView);

    /// An instance as the camera sees it.
    struct Placed {
        glm::dvec3 centre{0.0}; ///< right, up and ahead of the camera
        glm::dmat3 basis{1.0};  ///< from object space to these axes
        double radius = 0.0;    ///< of its bounding sphere
        double rounding =
            0.0; ///< of its vertices on the device, in scene units, before they are snapped to pixels
    };
    /// @param position in world space. @param radius of the bounding sphere, there.
    Placed placed(const glm::dvec3& position, const glm::mat3& basis, float radius) const;

    /// Whether the cascade holds all of an instance, so that none of its chunks need be looked at.
    bool holdsAll(const Placed& instance) const;
    /// Whether the cascade may show triangles of a chunk.
    bool mayShow(const Placed& instance, const MeshChunk& chunk) const;

  private:
    glm::dvec3 m_position;
    glm::dmat3 m_toView;
    std::array<HalfSpace, 6> m_sides;
    double m_anchorView;
    double m_pixel; ///< what snapped vertices may move by, per unit of distance
};

} // namespace cdr::visibility
