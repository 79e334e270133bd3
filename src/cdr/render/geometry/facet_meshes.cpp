#include <cdr/render/geometry/facet_meshes.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace cdr::render {

std::uint32_t FacetMeshes::add(const scene::Mesh& mesh) {
    std::vector<FacetSolid> solids;
    const auto make = [&](const std::vector<std::uint32_t>& indices) {
        std::optional<FacetSolid> solid = FacetSolid::of(mesh, indices);
        if (solid) {
            solids.push_back(std::move(*solid));
        }
        return solid.has_value();
    };
    const auto makeLevel = [&](const scene::MeshLevel& level) { return make(level.indices); };
    if (!make(mesh.indices) || !std::all_of(mesh.levels.begin(), mesh.levels.end(), makeLevel)) {
        return kNone;
    }
    const auto first = static_cast<std::uint32_t>(m_solids.size());
    for (FacetSolid& solid : solids) {
        const FacetPattern& whole = solid.whole();
        m_most.vertices = std::max(m_most.vertices, static_cast<std::uint32_t>(whole.vertices.size()));
        m_most.indices = std::max(m_most.indices, static_cast<std::uint32_t>(whole.indices.size()));
        m_most.facets = std::max(m_most.facets, static_cast<std::uint32_t>(whole.facets.size()));
        m_solids.push_back(std::move(solid));
    }
    return first;
}

FacetMeshes FacetMeshes::of(const scene::Scene& scene, const UploadedScene& gpuScene) {
    FacetMeshes meshes;
    std::map<std::uint32_t, std::uint32_t> firstOfMesh;
    for (const DrawKind& kind : gpuScene.kinds()) {
        if (kind.variant != kFacetedVariant) {
            meshes.m_firstOfKind.push_back(kNone);
            continue;
        }
        const auto [first, isNew] = firstOfMesh.try_emplace(kind.meshIndex, kNone);
        if (isNew) {
            first->second = meshes.add(scene.meshes[kind.meshIndex]);
        }
        meshes.m_firstOfKind.push_back(first->second);
    }
    return meshes;
}

bool FacetMeshes::suffice(const scene::Scene& scene, const UploadedScene& gpuScene) const {
    if (std::find(m_firstOfKind.begin(), m_firstOfKind.end(), kNone) == m_firstOfKind.end()) {
        return true;
    }
    for (std::size_t i = 0; i < gpuScene.sources().size(); ++i) {
        const bool isThere = scene.instances.radius[i] != scene::kNoRadius;
        if (isThere && m_firstOfKind[gpuScene.sources()[i].kind] == kNone) {
            return false;
        }
    }
    return true;
}

std::uint64_t bytesPerDraw(const FacetCounts& most, std::size_t litStride) {
    const std::uint64_t ofFacets = litStride > 0
                                       ? std::uint64_t{most.vertices} * litStride * sizeof(glm::vec3)
                                       : std::uint64_t{most.facets} * sizeof(shaders::FacetRecord);
    return std::uint64_t{most.vertices} * sizeof(shaders::FacetVertex) +
           std::uint64_t{most.indices} * sizeof(std::uint32_t) + ofFacets;
}

} // namespace cdr::render
