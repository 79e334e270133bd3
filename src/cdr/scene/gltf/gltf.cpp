#include "cameras.h"
#include "checks.h"
#include "container.h"
#include "import.h"
#include "json.h"
#include "material.h"
#include "memory.h"
#include "nodes.h"
#include "triangles.h"

#include <cdr/host/file.h>
#include <cdr/scene/gltf/gltf.h>
#include <cdr/scene/lod/mesh_pieces.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

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
          m_accessors(sources.document.root, sources.buffers),
          m_meshes(m_accessors, sources.notes),
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
    /// Reads a mesh and adds what it takes; returns its triangles.
    std::uint64_t readBounded(int mesh, MemoryPrediction& memory);
    void addObject(const MeshNode& node);
    const std::vector<PlacedPrimitive>& use(int mesh);
    /// A material of the scene in the layer of a node, if the node has one.
    std::uint32_t materialIn(std::optional<float> layer, std::uint32_t material);

    Sources m_sources;
    GltfLimits m_limits;
    Scene m_scene;
    Accessors m_accessors;
    MeshImporter m_meshes;
    MaterialImporter m_materials;
    std::map<int, MeshSource> m_sourceMeshes;                           ///< by mesh, those of the scene
    std::map<int, std::vector<PlacedPrimitive>> m_imported;             ///< by mesh
    std::map<std::pair<std::uint32_t, float>, std::uint32_t> m_layered; ///< by material and layer
    std::map<int, double> m_stretch;                                    ///< by mesh, the largest of its nodes
};

void Importer::requireBounded(const std::vector<MeshNode>& nodes) {
    if (nodes.size() > kMaxObjects) {
        refuse("{} objects are over the limit of {}", nodes.size(), kMaxObjects);
    }
    MemoryPrediction memory(m_limits.maxBytes);
    std::map<int, std::uint64_t> trianglesOf;
    std::uint64_t triangles = 0;
    std::uint64_t instances = 0;
    for (const MeshNode& node : nodes) {
        const auto [found, isNew] = trianglesOf.try_emplace(node.mesh, 0);
        if (isNew) {
            found->second = readBounded(node.mesh, memory);
        }
        triangles += found->second;
        instances += m_sourceMeshes.at(node.mesh).primitives.size();
        if (triangles > m_limits.maxTriangles) {
            refuse("its triangles, repeats counted, are over the limit of {}", m_limits.maxTriangles);
        }
    }
    memory.addInstances(instances);
}

std::uint64_t Importer::readBounded(int mesh, MemoryPrediction& memory) {
    const MeshSource& source =
        m_sourceMeshes.emplace(mesh, readMesh(m_sources.document.root, mesh)).first->second;
    std::uint64_t triangles = 0;
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        triangles += triangleCount(source.primitives[i], m_accessors);
        const Primitive& primitive = source.primitives[i];
        memory.add(
            predictBytes(primitive, m_accessors, mayHaveDetail(m_sources.document.root, primitive.material)),
            placeOf(mesh, source.name, i));
    }
    return triangles;
}

void Importer::addObject(const MeshNode& node) {
    const std::string name = fullNameOf(itemAt(m_sources.document.root, "nodes", node.node, "node"));
    const std::string& meshName = m_sourceMeshes.at(node.mesh).name;
    const auto object = static_cast<std::uint32_t>(m_scene.objectNames.size());
    m_scene.objectNames.push_back(!name.empty()       ? name
                                  : !meshName.empty() ? meshName
                                                      : fmt::format("node {}", node.node));
    const glm::dmat3 linear(node.toWorld);
    const glm::mat3 basis(linear);
    if (isFlat(linear, basis)) {
        m_sources.notes.add("not drawn, its transform flattens it", fmt::format("node {}", node.node));
        return;
    }
    for (const PlacedPrimitive& primitive : use(node.mesh)) {
        const std::size_t first = m_scene.instances.size();
        placePieces(m_scene, primitive.pieces, materialIn(node.layer, primitive.material), object,
                    node.toWorld);
        for (std::size_t i = first; i < m_scene.instances.size(); ++i) {
            const glm::dvec3 position = m_scene.instances.position(i);
            if (!std::isfinite(m_scene.instances.radius[i]) || !std::isfinite(glm::dot(position, position))) {
                refuse("node {} '{}': its size or place is over what can be drawn", node.node,
                       oneLine(name, kMaxNameLength));
            }
        }
    }
}

const std::vector<PlacedPrimitive>& Importer::use(int meshIndex) {
    const auto [found, isNew] = m_imported.try_emplace(meshIndex);
    if (!isNew) {
        return found->second;
    }
    const MeshSource& source = m_sourceMeshes.at(meshIndex);
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        const Primitive& primitive = source.primitives[i];
        const std::string where = placeOf(meshIndex, source.name, i);
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

std::uint32_t Importer::materialIn(std::optional<float> layer, std::uint32_t material) {
    if (!layer || *layer == m_scene.materials[material].layer) {
        return material;
    }
    const auto next = static_cast<std::uint32_t>(m_scene.materials.size());
    const auto [found, isNew] = m_layered.try_emplace({material, *layer}, next);
    if (isNew) {
        Material layered = m_scene.materials[material];
        layered.name = oneLine(layered.name, kMaxNameLength); // nodes are many, and names may be long
        layered.layer = *layer;
        m_scene.materials.push_back(std::move(layered));
    }
    return found->second;
}

GltfImport importParts(std::span<const std::uint8_t> file, const std::filesystem::path& path,
                       const GltfLimits& limits, std::optional<std::uint32_t> scene) {
    const Container container = openContainer(file);
    Notes notes;
    const Document document = parseDocument(container.json, limits, notes);
    Files files(path.parent_path(), limits);
    const Buffers buffers(document.root, container.bin, files);
    GltfImport result;
    const PlacedNodes nodes = placeNodes(document.root, limits, scene, notes);
    result.scene = Importer({document, buffers, files, notes}, limits).run(nodes.meshes);
    result.cameras = placeCameras(nodes.cameras, document, notes);
    result.scene.name = path.stem().string();
    if (result.scene.instances.size() == 0) {
        notes.add("nothing of it is drawn", "the scene");
    }
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
