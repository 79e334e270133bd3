#pragma once

#include <cdr/render/geometry/facet_solid.h>
#include <cdr/render/geometry/facet_writer.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::render {

/// The meshes of a scene whose every instance is drawn by facets.
class FacetMeshes {
  public:
    /// Empty where the scene has an opaque instance that is not: textured, masked, double-sided or blended, or of
    /// a mesh that is no FacetSolid at one of its levels.
    static std::optional<FacetMeshes> of(const scene::Scene& scene, const GpuScene& gpuScene);

    /// @param kind into GpuScene::kinds(). @param level of detail, 0 for the mesh itself.
    const FacetSolid& solid(std::uint32_t kind, std::uint32_t level) const {
        return m_solids[m_firstOfKind[kind] + level];
    }
    /// The most that one draw may write.
    const FacetCounts& most() const { return m_most; }

  private:
    std::vector<FacetSolid> m_solids;         ///< mesh by mesh, level by level
    std::vector<std::uint32_t> m_firstOfKind; ///< into m_solids
    FacetCounts m_most;
};

/// Bytes that the drawing of one instance in one cascade takes at most.
std::uint64_t bytesPerDraw(const FacetCounts& most);

} // namespace cdr::render
