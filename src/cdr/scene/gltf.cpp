#include "gltf_checks.h"
#include "gltf_container.h"
#include "gltf_import.h"
#include "gltf_material.h"
#include "gltf_nodes.h"
#include "gltf_triangles.h"

#include <cdr/base/file.h>
#include <cdr/scene/gltf.h>

#include <cmath>
#include <map>

namespace cdr::scene {

namespace gltf {

namespace {

/// A mesh of the file whose primitives are in the scene.
struct PlacedPrimitive {
    std::uint32_t mesh = 0;     ///< index into Scene::meshes
    std::uint32_t material = 0; ///< index into Scene::materials
    glm::dvec3 centre{0.0};     ///< where the mesh's origin goes in the space of the glTF mesh
};

/// Whether a transform flattens what it draws; relative to its scale, so small is not flat.
bool isFlat(const glm::dmat3& linear, const glm::mat3& basis) {
    // Below this the columns differ from a plane by less than float32 can tell.
    constexpr double kLeastRelativeVolume = 1e-9;
    const double volume = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    return !(std::abs(glm::determinant(linear)) > kLeastRelativeVolume * volume) ||
           !(std::abs(glm::determinant(glm::dmat3(basis))) > 0.0);
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

    Scene run() {
        const std::vector<MeshNode> nodes = meshNodes(m_sources.document.model, m_limits);
        requireBounded(nodes);
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
        const glm::dvec3 position(node.toWorld * glm::dvec4(primitive.centre, 1.0));
        addInstance(m_scene, primitive.mesh, primitive.material, object, position, basis);
        if (!std::isfinite(m_scene.instances.radius.back()) || !std::isfinite(glm::dot(position, position))) {
            refuse("node {} '{}': its size or place is over what can be drawn", node.node,
                   oneLine(source.name));
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
        std::optional<CentredMesh> mesh = m_meshes.import(primitive, material.uv, where);
        if (!mesh) {
            continue;
        }
        found->second.push_back(
            {static_cast<std::uint32_t>(m_scene.meshes.size()), material.index, mesh->centre});
        m_scene.meshes.push_back(std::move(mesh->mesh));
    }
    return found->second;
}

GltfImport importParts(std::span<const std::uint8_t> file, const std::filesystem::path& path,
                       const GltfLimits& limits) {
    const Container container = openContainer(file);
    Notes notes;
    const Document document = parseDocument(container.json, limits, notes);
    Files files(path.parent_path(), limits);
    const Buffers buffers(document.buffers, container.bin, files);
    GltfImport result;
    result.scene = Importer({document, buffers, files, notes}, limits).run();
    result.scene.name = path.stem().string();
    result.ignored = notes.lines();
    return result;
}

} // namespace

GltfImport importGltf(std::span<const std::uint8_t> file, const std::filesystem::path& path,
                      const GltfLimits& limits) {
    try {
        return importParts(file, path, limits);
    } catch (const base::InputError& error) {
        throw base::InputError(fmt::format("{}: {}", path.string(), oneLine(error.what())));
    }
}

} // namespace gltf

GltfImport loadGltf(const std::filesystem::path& path, const GltfLimits& limits) {
    return gltf::importGltf(base::readFile(path, limits.maxFileBytes), path, limits);
}

} // namespace cdr::scene
