#include "animation/moving_parts.h"
#include "bytes/container.h"
#include "bytes/read_progress.h"
#include "checks.h"
#include "document.h"
#include "draco/decompressor.h"
#include "import.h"
#include "instancing.h"
#include "json.h"
#include "materials/material.h"
#include "memory.h"
#include "nodes/cameras.h"
#include "nodes/lights.h"
#include "nodes/nodes.h"
#include "part_names.h"
#include "solids/solids.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <cdr/scene/gltf/gltf.h>
#include <cdr/scene/lod/mesh_pieces.h>
#include <cdr/scene/world/check.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace cdr::scene {

namespace gltf {

namespace {

using nlohmann::json;

/// A mesh of the file whose primitives are in the scene.
struct PlacedPrimitive {
    PieceSet pieces;            ///< in the space of the glTF mesh
    std::uint32_t material = 0; ///< index into Scene::materials
};

/// A primitive that deforms, as a node has it.
struct DeformedPrimitive {
    std::size_t deformed = 0;   ///< index into SceneAnimation::deformed
    std::uint32_t material = 0; ///< index into Scene::materials
};

/// Whether a transform flattens what it draws; relative to its scale, so small is not flat.
bool isFlat(const glm::dmat3& linear, const glm::mat3& basis) {
    // Below this the columns differ from a plane by less than float32 can tell.
    constexpr double kMinRelativeVolume = 1e-9;
    const double volume = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    return !(std::abs(glm::determinant(linear)) > kMinRelativeVolume * volume) ||
           !(std::abs(glm::determinant(glm::dmat3(basis))) > 0.0);
}

/// What an instance that moves takes beside itself, with the growth of what holds it.
constexpr std::uint64_t kCarriedBytes = 3 * sizeof(CarriedInstance);
/// What a copy of a mesh takes beside its instances: a name, and where it moves its place.
constexpr std::uint64_t kCopyBytes = sizeof(std::string) + kMaxNameLength + kCarriedBytes;
/// What one of several parts of a mesh takes beside its instance: a name made of two.
constexpr std::uint64_t kPartBytes = sizeof(std::string) + 3 * kMaxNameLength;

/// Most materials that layers of nodes make beside those of the file, which has no more of its own.
constexpr std::size_t kMaxLayeredMaterials = 65'536;

[[noreturn]] void refuseObjects(std::uint64_t objects) {
    refuse("{} objects are over the limit of {}", objects, kMaxObjects);
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
          m_memory(limits.maxBytes),
          m_accessors(sources.document, sources.buffers),
          m_decompressor(sources.buffers, m_accessors, limits.maxFileBytes),
          m_meshes(m_accessors, m_memory, sources.notes),
          m_materials(sources, m_scene) {}

    void run(const PlacedNodes& nodes, GltfImport& result) {
        m_moving.emplace(m_sources.document, nodes, m_accessors, m_memory, m_sources.notes);
        readCopies(nodes.meshes);
        requireBounded(nodes.meshes);
        for (const MeshNode& node : nodes.meshes) {
            double& stretch = m_stretch[node.mesh];
            forEachCopy(node,
                        [&](const MeshNode& copy) { stretch = std::max(stretch, stretchOf(copy.toWorld)); });
        }
        addNodes(nodes.meshes);
        result.animation = m_moving->finish(m_scene);
        result.rigNodeOf = m_moving->rigNodes();
        result.scene = std::move(m_scene);
    }

  private:
    void requireBounded(const std::vector<MeshNode>& nodes);
    /// Adds all nodes and their textures, and tells how far it is.
    void addNodes(const std::vector<MeshNode>& nodes);
    /// About how many bytes are read when a node is the first one of its mesh.
    std::uint64_t readBytes(int mesh);
    /// Reads a mesh and adds what its parts take; returns its triangles.
    std::uint64_t readBounded(int mesh);
    void addNode(const MeshNode& node);
    /// Each primitive is an object, so that what is wrong between them is seen.
    void addObjects(const MeshNode& node, const std::vector<std::string>& names);
    void addPart(const MeshNode& node, std::size_t index, std::uint32_t object);
    /// Reads where the nodes' meshes are copied to; bounds the copies.
    void readCopies(const std::vector<MeshNode>& nodes);
    std::uint64_t countOf(const MeshNode& node) const;
    void addRigid(const MeshNode& node, std::size_t index, std::uint32_t object);
    /// Adds what a primitive takes for being of several pieces, which is known once it is cut.
    void countPieces(const MeshNode& node, const PieceSet& pieces);
    /// A node as each of its copies stands, or as it is where it has none.
    void forEachCopy(const MeshNode& node, const std::function<void(const MeshNode&)>& add);
    void addDeformed(const MeshNode& node, std::size_t index, std::uint32_t object);
    /// Nothing when the primitive has nothing to draw.
    std::optional<DeformedPrimitive> readDeformed(const MeshNode& node, std::size_t index);
    /// A primitive of a mesh that was read, decoded.
    const Primitive& decoded(int mesh, std::size_t index, const std::string& where);
    const std::optional<PlacedPrimitive>& use(int meshIndex, std::size_t index);
    /// The limits' radius of points in the space of a mesh that its nodes stretch so.
    std::optional<double> pointRadius(double stretch) const;
    /// A material of the scene in the layer of a node, if the node has one.
    std::uint32_t materialIn(std::optional<float> layer, std::uint32_t material);

    Sources m_sources;
    GltfLimits m_limits;
    MemoryPrediction m_memory;
    Scene m_scene;
    Accessors m_accessors;
    Decompressor m_decompressor;
    MeshImporter m_meshes;
    MaterialImporter m_materials;
    std::optional<MovingParts> m_moving;      ///< while it runs
    std::map<int, MeshSource> m_sourceMeshes; ///< by mesh, those of the scene
    std::map<int, MeshCopies> m_copies;       ///< by node, where it has some
    std::map<std::pair<int, std::size_t>, std::optional<PlacedPrimitive>>
        m_imported; ///< by mesh and primitive
    std::map<std::pair<int, std::size_t>, std::optional<DeformedPrimitive>>
        m_deformed;                                                     ///< by node and primitive
    std::map<std::pair<std::uint32_t, float>, std::uint32_t> m_layered; ///< by material and layer
    std::map<int, double> m_stretch;                                    ///< by mesh, the largest of its nodes
};

void Importer::forEachCopy(const MeshNode& node, const std::function<void(const MeshNode&)>& add) {
    const auto found = m_copies.find(node.node);
    if (found == m_copies.end()) {
        add(node);
        return;
    }
    MeshNode copy = node;
    for (std::size_t i = 0; i < found->second.count(); ++i) {
        copy.toNode = found->second.toNode(i);
        copy.toWorld = node.toWorld * *copy.toNode;
        add(copy);
    }
}

std::uint64_t Importer::countOf(const MeshNode& node) const {
    const auto found = m_copies.find(node.node);
    return found == m_copies.end() ? 1 : found->second.count();
}

void Importer::readCopies(const std::vector<MeshNode>& nodes) {
    std::uint64_t objects = 0;
    for (const MeshNode& node : nodes) {
        const json& source = itemAt(m_sources.document, "nodes", node.node, "node");
        if (const json* extension = extensionOf(source, kInstancing)) {
            const auto copies =
                m_copies.try_emplace(node.node, *extension, m_accessors, fmt::format("node {}", node.node));
            m_memory.add({.kept = copies.first->second.count() * kCopyBytes, .passing = 0},
                         "copies of a mesh");
        }
        objects += countOf(node);
    }
    if (objects > kMaxObjects) {
        refuseObjects(objects);
    }
}

void Importer::requireBounded(const std::vector<MeshNode>& nodes) {
    std::map<int, std::uint64_t> trianglesOf;
    std::uint64_t triangles = 0;
    std::uint64_t instances = 0;
    for (const MeshNode& node : nodes) {
        const auto [found, isNew] = trianglesOf.try_emplace(node.mesh, 0);
        if (isNew) {
            found->second = readBounded(node.mesh);
        }
        for (const Primitive& primitive : m_sourceMeshes.at(node.mesh).primitives) {
            if (m_moving->deforms(node, primitive)) {
                m_memory.add(m_moving->predict(node, primitive), fmt::format("node {}", node.node));
            }
        }
        const std::uint64_t copies = countOf(node);
        const std::uint64_t parts = m_sourceMeshes.at(node.mesh).primitives.size();
        if (found->second > 0 && copies > m_limits.maxTriangles / found->second) {
            refuse("its triangles, repeats counted, are over the limit of {}", m_limits.maxTriangles);
        }
        triangles += copies * found->second;
        instances += copies * parts;
        if (parts > 1) {
            m_memory.add({.kept = copies * parts * kPartBytes, .passing = 0}, "parts of a mesh");
        }
        if (triangles > m_limits.maxTriangles) {
            refuse("its triangles, repeats counted, are over the limit of {}", m_limits.maxTriangles);
        }
    }
    if (instances > kMaxObjects) {
        refuseObjects(instances);
    }
    m_memory.addInstances(instances, fmt::format("{} instances", instances));
}

void Importer::addNodes(const std::vector<MeshNode>& nodes) {
    std::vector<std::uint64_t> bytes;
    std::set<int> isRead;
    std::uint64_t all = 0;
    for (const MeshNode& node : nodes) {
        bytes.push_back(1 + (isRead.insert(node.mesh).second ? readBytes(node.mesh) : 0));
        all += bytes.back();
    }
    const std::size_t pictures = arrayMember(m_sources.document, "images").size();
    ReadProgress progress(m_limits.progress, all + pictures * kPictureBytes);
    m_sources.buffers.blocks().tell(&progress);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        progress.begin(bytes[i]);
        addNode(nodes[i]);
    }
    m_sources.buffers.blocks().tell(nullptr);
    progress.begin(pictures * kPictureBytes);
    progress.tell();
    m_materials.decodeTextures(m_limits, progress);
    progress.begin(0); // pictures that nothing shows are done too
    progress.tell();
}

std::uint64_t Importer::readBytes(int mesh) {
    std::uint64_t bytes = 0;
    for (const Primitive& primitive : m_sourceMeshes.at(mesh).primitives) {
        const auto positions = primitive.attributes.find("POSITION");
        if (positions != primitive.attributes.end()) {
            bytes += primitive.attributes.size() * m_accessors.at(positions->second).bytes();
        }
        if (primitive.indices >= 0) {
            bytes += m_accessors.at(primitive.indices).bytes();
        }
    }
    return bytes;
}

std::uint64_t Importer::readBounded(int mesh) {
    const MeshSource& source = m_sourceMeshes.emplace(mesh, readMesh(m_sources.document, mesh)).first->second;
    std::uint64_t triangles = 0;
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        triangles += drawnTriangleCount(source.primitives[i], m_accessors);
        const Primitive& primitive = source.primitives[i];
        requireTargets(m_sources.document, primitive, m_accessors, placeOf(mesh, source.name, i));
        const VertexKind kind =
            mayHaveDetail(m_sources.document, primitive.material) ? VertexKind::detailed : VertexKind::plain;
        m_memory.add(predictBytes(primitive, m_accessors, kind), placeOf(mesh, source.name, i));
    }
    return triangles;
}

void Importer::addNode(const MeshNode& node) {
    const std::string_view nodeName = fullNameOf(itemAt(m_sources.document, "nodes", node.node, "node"));
    const std::string& meshName = m_sourceMeshes.at(node.mesh).name;
    // A mesh may be that of many nodes, so what they take of its name is bounded.
    const std::string name = !nodeName.empty()   ? std::string(nodeName)
                             : !meshName.empty() ? oneLine(meshName, kMaxNameLength)
                                                 : fmt::format("node {}", node.node);
    std::size_t copies = 0;
    forEachCopy(node, [&](const MeshNode& copy) {
        const std::string own =
            copy.toNode ? fmt::format("{} {}", oneLine(name, kMaxNameLength), copies++) : name;
        addObjects(copy, partNames(m_sources.document, m_sourceMeshes.at(node.mesh), own));
    });
}

void Importer::addObjects(const MeshNode& node, const std::vector<std::string>& names) {
    const auto first = static_cast<std::uint32_t>(m_scene.objectNames.size());
    m_scene.objectNames.insert(m_scene.objectNames.end(), names.begin(), names.end());
    for (std::size_t i = 0; i < m_sourceMeshes.at(node.mesh).primitives.size(); ++i) {
        addPart(node, i, first + static_cast<std::uint32_t>(i));
    }
}

void Importer::addPart(const MeshNode& node, std::size_t index, std::uint32_t object) {
    const Primitive& primitive = m_sourceMeshes.at(node.mesh).primitives[index];
    if (!m_moving->deforms(node, primitive)) {
        addRigid(node, index, object);
    } else if (node.toNode && node.skin && primitive.jointSets > 0) {
        m_sources.notes.add("copies of a mesh with a skin are not drawn: no node places its joints, and the "
                            "extension does not say what does",
                            fmt::format("node {}", node.node));
    } else {
        addDeformed(node, index, object);
    }
}

void Importer::addRigid(const MeshNode& node, std::size_t index, std::uint32_t object) {
    const glm::dmat3 linear(node.toWorld);
    const bool flat = isFlat(linear, glm::mat3(linear));
    if (flat && !m_moving->moves(node)) {
        m_sources.notes.add("not drawn, because its transform is not invertible",
                            fmt::format("node {}", node.node));
        return;
    }
    const std::optional<PlacedPrimitive>& primitive = use(node.mesh, index);
    if (!primitive) {
        return;
    }
    countPieces(node, primitive->pieces);
    const std::size_t first = m_scene.instances.size();
    placePieces(m_scene, primitive->pieces, materialIn(node.layer, primitive->material), object,
                node.toWorld);
    for (std::size_t i = first; i < m_scene.instances.size(); ++i) {
        if (flat) {
            placeInstance(m_scene, i, m_scene.instances.position(i), glm::mat3(0.0f));
        }
        const Transform placed{m_scene.instances.position(i), m_scene.instances.basis[i]};
        if (!isUsable(placed) || !std::isfinite(m_scene.instances.radius[i]) ||
            !std::isfinite(glm::dot(placed.position, placed.position))) {
            refuse("node {} '{}': its size or place is over what can be drawn", node.node,
                   oneLine(m_scene.objectNames[object], kMaxNameLength));
        }
        m_moving->carry(node, static_cast<std::uint32_t>(i), primitive->pieces.origins[i - first]);
    }
}

void Importer::addDeformed(const MeshNode& node, std::size_t index, std::uint32_t object) {
    const auto [found, isNew] = m_deformed.try_emplace({node.node, index});
    if (isNew) {
        found->second = readDeformed(node, index);
    }
    if (found->second) {
        m_moving->place(m_scene, found->second->deformed, node,
                        materialIn(node.layer, found->second->material), object);
    }
}

void Importer::countPieces(const MeshNode& node, const PieceSet& pieces) {
    const std::uint64_t more = pieces.origins.size() - 1; // requireBounded() counted one
    if (more > 0) {
        const std::string what = "pieces of a mesh";
        m_memory.addInstances(more, what);
        m_memory.add({.kept = m_moving->moves(node) ? more * kCarriedBytes : 0, .passing = 0}, what);
    }
}

std::optional<DeformedPrimitive> Importer::readDeformed(const MeshNode& node, std::size_t index) {
    const std::string where = placeOf(node.mesh, m_sourceMeshes.at(node.mesh).name, index);
    const Primitive& primitive = decoded(node.mesh, index, where);
    const MaterialUse& material = m_materials.use(primitive.material, groundOf(primitive));
    // The joints of a skin place its mesh, and not its node.
    const double stretch = node.skin && primitive.jointSets > 0 ? 1.0 : m_stretch[node.mesh];
    std::optional<SourcePrimitive> source =
        m_meshes.read(primitive, material.uv, pointRadius(stretch), where);
    if (!source) {
        return std::nullopt;
    }
    return DeformedPrimitive{m_moving->addDeformed(m_scene, node, primitive, std::move(*source), where),
                             material.index};
}

const Primitive& Importer::decoded(int mesh, std::size_t index, const std::string& where) {
    Primitive& primitive = m_sourceMeshes.at(mesh).primitives[index];
    const std::uint64_t kept = m_decompressor.decode(primitive, m_memory.left(), where);
    m_memory.add({.kept = kept, .passing = 0}, where);
    return primitive;
}

const std::optional<PlacedPrimitive>& Importer::use(int meshIndex, std::size_t index) {
    const auto [found, isNew] = m_imported.try_emplace({meshIndex, index});
    if (!isNew) {
        return found->second;
    }
    const std::string where = placeOf(meshIndex, m_sourceMeshes.at(meshIndex).name, index);
    const Primitive& primitive = decoded(meshIndex, index, where);
    const MaterialUse& material = m_materials.use(primitive.material, groundOf(primitive));
    // Pieces overlap at their seams, which blending would show.
    const bool whole = m_scene.materials[material.index].alphaMode == AlphaMode::blend;
    const double stretch = m_stretch[meshIndex];
    const MeshSizes sizes{.pieceRadius = whole ? INFINITY : m_limits.pieceRadius / stretch,
                          .pointRadius = pointRadius(stretch)};
    std::vector<MeshPiece> pieces = m_meshes.import(primitive, material.uv, sizes, where);
    m_memory.release(Decompressor::drop(m_sourceMeshes.at(meshIndex).primitives[index]));
    if (!pieces.empty()) {
        found->second = {addPieces(m_scene, std::move(pieces)), material.index};
    }
    return found->second;
}

std::optional<double> Importer::pointRadius(double stretch) const {
    if (!m_limits.pointRadius) {
        return std::nullopt;
    }
    // A node that an animation spreads out may be flat at rest.
    return std::min(*m_limits.pointRadius / (stretch > 0.0 ? stretch : 1.0),
                    static_cast<double>(std::numeric_limits<float>::max()));
}

std::uint32_t Importer::materialIn(std::optional<float> layer, std::uint32_t material) {
    if (!layer || *layer == m_scene.materials[material].layer) {
        return material;
    }
    const auto next = static_cast<std::uint32_t>(m_scene.materials.size());
    const auto [found, isNew] = m_layered.try_emplace({material, *layer}, next);
    if (isNew) {
        if (m_layered.size() > kMaxLayeredMaterials) {
            refuse("layers of nodes need over {} materials", kMaxLayeredMaterials);
        }
        Material& source = m_scene.materials[material];
        std::string name = std::exchange(source.name, {}); // nodes are many, and names may be long
        Material layered = source;
        source.name = std::move(name);
        layered.name = oneLine(source.name, kMaxNameLength);
        layered.layer = *layer;
        m_scene.materials.push_back(std::move(layered));
    }
    return found->second;
}

GltfImport importParts(const ByteSource& file, const std::filesystem::path& path, const GltfLimits& limits,
                       std::optional<std::uint32_t> scene) {
    Container container = openContainer(file);
    Notes notes;
    const json document = parseDocument(container.text(), limits, notes);
    container.json = platform::Bytes(); // which may be most of a file that has its buffers in data URIs
    Files files(file.file() != nullptr ? std::optional(path.parent_path()) : std::nullopt, limits);
    const Buffers buffers(document, container.bin, files, limits);
    GltfImport result;
    const PlacedNodes nodes = placeNodes(document, limits, scene, notes);
    Importer({document, buffers, files, notes}, limits).run(nodes, result);
    result.cameras = placeCameras(nodes.cameras, document, notes);
    result.lights = placeLights(nodes.lights, document, notes);
    result.scene.name = path.stem().string();
    if (result.scene.instances.size() == 0) {
        notes.add("nothing of it is drawn", "the scene");
    }
    result.ignored = notes.lines();
    return result;
}

} // namespace

GltfImport importGltf(const ByteSource& file, const std::filesystem::path& path, const GltfLimits& limits,
                      std::optional<std::uint32_t> scene) {
    try {
        return importParts(file, path, limits, scene);
    } catch (const base::InputError& error) {
        throw base::inputError("{}: {}", platform::oneLine(path), oneLine(error.what()));
    }
}

} // namespace gltf

GltfImport loadGltf(const std::filesystem::path& path, const GltfLimits& limits,
                    std::optional<std::uint32_t> scene) {
    const gltf::ByteSource file(std::make_shared<const gltf::OpenFile>(path, limits.maxFileBytes, ""));
    return gltf::importGltf(file, path, limits, scene);
}

GltfImport loadGltf(std::span<const std::byte> file, const std::string& name, const GltfLimits& limits,
                    std::optional<std::uint32_t> scene) {
    if (file.size() > limits.maxFileBytes) {
        throw base::inputError("{}: its {} bytes are over the limit of {}", gltf::oneLine(name), file.size(),
                               limits.maxFileBytes);
    }
    const gltf::ByteSource bytes(std::span(reinterpret_cast<const std::uint8_t*>(file.data()), file.size()));
    return gltf::importGltf(bytes, name, limits, scene);
}

} // namespace cdr::scene
