#include "cameras.h"
#include "checks.h"
#include "container.h"
#include "import.h"
#include "material.h"
#include "nodes.h"
#include "triangles.h"

#include <cdr/host/file.h>
#include <cdr/scene/gltf/gltf.h>
#include <cdr/scene/lod/mesh_pieces.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace cdr::scene {

namespace gltf {

namespace {

/// A mesh of the file whose primitives are in the scene.
struct PlacedPrimitive {
    PieceSet pieces;            ///< in the space of the glTF mesh
    std::uint32_t material = 0; ///< index into Scene::materials
};

/// Whether a transform flattens what it draws; relative to its scale, so small is not flat.
bool isFlat(const glm::dmat3& linear, const glm::mat3& basis) {
    // Below this the columns differ from a plane by less than float32 can tell.
    constexpr double kLeastRelativeVolume = 1e-9;
    const double volume = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    return !(std::abs(glm::determinant(linear)) > kLeastRelativeVolume * volume) ||
           !(std::abs(glm::determinant(glm::dmat3(basis))) > 0.0);
}

/// The longest column: by how much a transform stretches, within a factor of 1.74.
double stretchOf(const glm::dmat4& matrix) {
    const glm::dmat3 linear(matrix);
    return std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
}

/// One import. Meshes, materials and textures enter the scene when a node first needs them.
class Importer {
  public:
    Importer(const Sources& sources, const GltfLimits& limits)
        : m_sources(sources),
          m_limits(limits),
          m_accessors(sources.document.model, sources.buffers),
          m_meshes(m_accessors, sources.notes, 3 * limits.maxTriangles),
          m_materials(sources, m_scene) {}

    Scene run(const std::vector<MeshNode>& nodes) {
        requireBounded(nodes);
        for (const MeshNode& node : nodes) {
            double& stretch = m_stretch[node.mesh];
            stretch = std::max(stretch, stretchOf(node.toWorld));
        }
        for (const MeshNode& node : nodes) {
            addObject(node);
        }
        return std::move(m_scene);
    }

  private:
    void requireBounded(const std::vector<MeshNode>& nodes);
    void addObject(const MeshNode& node);
    const std::vector<PlacedPrimitive>& use(int mesh);

    Sources m_sources;
    GltfLimits m_limits;
    Scene m_scene;
    Accessors m_accessors;
    MeshImporter m_meshes;
    MaterialImporter m_materials;
    std::map<int, std::vector<PlacedPrimitive>> m_imported; ///< by mesh
    std::map<int, double> m_stretch;                        ///< by mesh, the largest of its nodes
};

void Importer::requireBounded(const std::vector<MeshNode>& nodes) {
    const tinygltf::Model& model = m_sources.document.model;
    if (nodes.size() > kMaxObjects) {
        refuse("{} objects are over the limit of {}", nodes.size(), kMaxObjects);
    }
    std::map<int, std::uint64_t> trianglesOf;
    std::uint64_t total = 0;
    for (const MeshNode& node : nodes) {
        const auto [found, isNew] = trianglesOf.try_emplace(node.mesh, 0);
        if (isNew) {
            for (const tinygltf::Primitive& primitive : itemAt(model.meshes, node.mesh, "mesh").primitives) {
                found->second += triangleCount(primitive, m_accessors);
            }
        }
        total += found->second;
        if (total > m_limits.maxTriangles) {
            refuse("its triangles, repeats counted, are over the limit of {}", m_limits.maxTriangles);
        }
    }
}

void Importer::addObject(const MeshNode& node) {
    const tinygltf::Node& source = m_sources.document.model.nodes[static_cast<std::size_t>(node.node)];
    const tinygltf::Mesh& mesh = itemAt(m_sources.document.model.meshes, node.mesh, "mesh");
    const auto object = static_cast<std::uint32_t>(m_scene.objectNames.size());
    m_scene.objectNames.push_back(!source.name.empty() ? source.name
                                  : !mesh.name.empty() ? mesh.name
                                                       : fmt::format("node {}", node.node));
    const glm::dmat3 linear(node.toWorld);
    const glm::mat3 basis(linear);
    if (isFlat(linear, basis)) {
        m_sources.notes.add("not drawn, its transform flattens it", fmt::format("node {}", node.node));
        return;
    }
    for (const PlacedPrimitive& primitive : use(node.mesh)) {
        const std::size_t first = m_scene.instances.size();
        placePieces(m_scene, primitive.pieces, primitive.material, object, node.toWorld);
        for (std::size_t i = first; i < m_scene.instances.size(); ++i) {
            const glm::dvec3 position = m_scene.instances.position(i);
            if (!std::isfinite(m_scene.instances.radius[i]) || !std::isfinite(glm::dot(position, position))) {
                refuse("node {} '{}': its size or place is over what can be drawn", node.node,
                       oneLine(source.name));
            }
        }
    }
}

const std::vector<PlacedPrimitive>& Importer::use(int meshIndex) {
    const auto [found, isNew] = m_imported.try_emplace(meshIndex);
    if (!isNew) {
        return found->second;
    }
    const tinygltf::Mesh& source = itemAt(m_sources.document.model.meshes, meshIndex, "mesh");
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        const tinygltf::Primitive& primitive = source.primitives[i];
        const std::string where =
            fmt::format("mesh {} '{}' primitive {}", meshIndex, oneLine(source.name), i);
        const MaterialUse& material = m_materials.use(primitive.material);
        // Pieces overlap at their seams, which blending would show.
        const bool whole = m_scene.materials[material.index].alphaMode == AlphaMode::blend;
        const double pieceRadius = whole ? INFINITY : m_limits.pieceRadius / m_stretch[meshIndex];
        std::vector<MeshPiece> pieces = m_meshes.import(primitive, material.uv, pieceRadius, where);
        if (!pieces.empty()) {
            found->second.push_back({addPieces(m_scene, std::move(pieces)), material.index});
        }
    }
    return found->second;
}

GltfImport importParts(std::span<const std::uint8_t> file, const std::filesystem::path& path,
                       const GltfLimits& limits, std::optional<std::uint32_t> scene) {
    const Container container = openContainer(file);
    Notes notes;
    const Document document = parseDocument(container.json, limits, notes);
    Files files(path.parent_path(), limits);
    const Buffers buffers(document.buffers, container.bin, files);
    GltfImport result;
    const PlacedNodes nodes = placeNodes(document.model, limits, scene);
    result.scene = Importer({document, buffers, files, notes}, limits).run(nodes.meshes);
    result.cameras = placeCameras(nodes.cameras, document, notes);
    result.scene.name = path.stem().string();
    result.ignored = notes.lines();
    return result;
}

} // namespace

GltfImport importGltf(std::span<const std::uint8_t> file, const std::filesystem::path& path,
                      const GltfLimits& limits, std::optional<std::uint32_t> scene) {
    try {
        return importParts(file, path, limits, scene);
    } catch (const base::InputError& error) {
        throw base::InputError(fmt::format("{}: {}", path.string(), oneLine(error.what())));
    }
}

} // namespace gltf

GltfImport loadGltf(const std::filesystem::path& path, const GltfLimits& limits,
                    std::optional<std::uint32_t> scene) {
    return gltf::importGltf(host::readFile(path, limits.maxFileBytes), path, limits, scene);
}

} // namespace cdr::scene
