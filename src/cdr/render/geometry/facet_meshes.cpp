#include <cdr/render/geometry/facet_meshes.h>

#include <algorithm>
#include <map>

namespace cdr::render {

std::optional<FacetMeshes> FacetMeshes::of(const scene::Scene& scene, const GpuScene& gpuScene) {
    FacetMeshes meshes;
    std::map<std::uint32_t, std::uint32_t> firstOfMesh;
    const auto add = [&](const scene::Mesh& mesh, const std::vector<std::uint32_t>& indices) {
        std::optional<FacetSolid> solid = FacetSolid::of(mesh, indices);
        if (!solid) {
            return false;
        }
        const FacetPattern& whole = solid->whole();
        FacetCounts& most = meshes.m_most;
        most.vertices = std::max(most.vertices, static_cast<std::uint32_t>(whole.vertices.size()));
        most.indices = std::max(most.indices, static_cast<std::uint32_t>(whole.indices.size()));
        most.facets = std::max(most.facets, static_cast<std::uint32_t>(whole.facets.size()));
        meshes.m_solids.push_back(std::move(*solid));
        return true;
    };
    for (const DrawKind& kind : gpuScene.kinds()) {
        const auto [first, isNew] =
            firstOfMesh.try_emplace(kind.meshIndex, static_cast<std::uint32_t>(meshes.m_solids.size()));
        meshes.m_firstOfKind.push_back(first->second);
        if (kind.variant != kFacetedVariant) {
            return std::nullopt;
        }
        if (!isNew) {
            continue;
        }
        const scene::Mesh& mesh = scene.meshes[kind.meshIndex];
        const auto addLevel = [&](const scene::MeshLevel& level) { return add(mesh, level.indices); };
        if (!add(mesh, mesh.indices) || !std::all_of(mesh.levels.begin(), mesh.levels.end(), addLevel)) {
            return std::nullopt;
        }
    }
    return meshes;
}

std::uint64_t bytesPerDraw(const FacetCounts& most) {
    return std::uint64_t{most.vertices} * sizeof(shaders::FacetVertex) +
           std::uint64_t{most.indices} * sizeof(std::uint32_t) +
           std::uint64_t{most.facets} * sizeof(shaders::FacetRecord);
}

} // namespace cdr::render
