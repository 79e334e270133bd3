#pragma once

#include <cdr/render/geometry/facet_solid.h>
#include <cdr/render/geometry/facet_writer.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// The meshes of a scene whose every instance is drawn by facets.
class FacetMeshes {
  public:
    /// Of the kinds of draws that the scene has.
    static FacetMeshes of(const scene::Scene& scene, const UploadedScene& gpuScene);

    /// Whether every instance can be drawn by facets. None may be textured, masked, double-sided or blended,
    /// and every mesh must be a FacetSolid at all of its levels. Takes time by the number of instances where
    /// some kind cannot.
    bool suffice(const scene::Scene& scene, const UploadedScene& gpuScene) const;

    /// @param kind into UploadedScene::kinds(). @param level of detail, 0 for the mesh itself.
    const FacetSolid& solid(std::uint32_t kind, std::uint32_t level) const {
        return m_solids[m_firstOfKind[kind] + level];
    }
    /// The most that one draw may write.
    const FacetCounts& most() const { return m_most; }

  private:
    static constexpr std::uint32_t kNone = ~0u;
    /// A mesh and its levels; kNone where one of them is no FacetSolid.
    std::uint32_t add(const scene::Mesh& mesh);

    std::vector<FacetSolid> m_solids;         ///< mesh by mesh, level by level
    std::vector<std::uint32_t> m_firstOfKind; ///< into m_solids; kNone where facets do not do
    FacetCounts m_most;
};

/// Bytes that the drawing of one instance in one cascade takes at most.
/// @param litStride FacetLight::stride() where facets are lit while they are drawn, else 0.
std::uint64_t bytesPerDraw(const FacetCounts& most, std::size_t litStride = 0);

} // namespace cdr::render
