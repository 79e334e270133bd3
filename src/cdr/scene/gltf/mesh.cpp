#include "mesh.h"

#include "bytes/reading_order.h"
#include "checks.h"
#include "draco/decompressor.h"
#include "materials/mikktspace_tangents.h"
#include "materials/tangents.h"
#include "triangles.h"

#include <cdr/scene/box_tree.h>
#include <cdr/scene/world/check.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace cdr::scene::gltf {

namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
constexpr glm::vec3 kAnyNormal{0.0f, 0.0f, 1.0f};

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Of length one, or nothing when the length is zero or not finite.
std::optional<glm::vec3> normalized(const glm::dvec3& v) {
    const double length = glm::length(v);
    if (!(length > 0.0) || !std::isfinite(length)) {
        return {};
    }
    return glm::vec3(v / length);
}

void requireFinite(const glm::vec3& position, std::uint32_t index, const std::string& where) {
    if (!isFinite(position)) {
        refuse("{}: the position of vertex {} is not finite", where, index);
    }
}

/// The sides of the box of what is drawn.
glm::dvec3 sidesOf(std::span<const SolidEnds> solids, const Accessor& positions, const std::string& where) {
    Box box;
    for (const SolidEnds& ends : solids) {
        for (const std::uint32_t index : {ends.first, ends.second}) {
            const glm::vec3 position(positions.vector(index));
            requireFinite(position, index, where);
            box.add(glm::dvec3(position));
        }
    }
    return solids.empty() ? glm::dvec3(0.0) : box.high - box.low;
}

std::uint8_t toUnorm8(float value) {
    // The comparison also sends NaN to 0.
    const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
    return static_cast<std::uint8_t>(std::lround(clamped * 255.0f));
}

} // namespace

/// The accessors a primitive's vertices come from; null where it has none.
struct MeshImporter::Attributes {
    const Accessor* position = nullptr;
    const Accessor* normal = nullptr;
    const Accessor* uv = nullptr;
    const Accessor* color = nullptr;
    const Accessor* secondUv = nullptr;
    const Accessor* tangent = nullptr;
    UvPlaces places;
};

MeshImporter::MeshImporter(Accessors& accessors, const MemoryPrediction& memory, Notes& notes)
    : m_accessors(accessors),
      m_memory(memory),
      m_notes(notes) {}

std::optional<SourcePrimitive> MeshImporter::read(const Primitive& primitive, const UvPlaces& uv,
                                                  std::optional<double> pointRadius,
                                                  const std::string& where) {
    if (primitive.mode < kModePoints || primitive.mode > kModeTriangleFan) {
        refuse("{}: mode {} does not exist", where, primitive.mode);
    }
    // glTF: such a primitive should not be drawn. What has no data is all zeros, unless an extension has it.
    const Accessor* position = attributeOf(primitive, "POSITION", m_accessors);
    if (position == nullptr || (primitive.hasExtensions && !position->hasData() && !position->isSparse())) {
        m_notes.add(primitive.hasExtensions ? "not drawn, because no positions of it can be read"
                                            : "not drawn, because it has no positions",
                    where);
        return std::nullopt;
    }
    return groundOf(primitive) == Ground::surface ? readTriangles(primitive, uv, where)
                                                  : readSolids(primitive, uv, pointRadius, where);
}

std::optional<SourcePrimitive> MeshImporter::readTriangles(const Primitive& primitive, const UvPlaces& uv,
                                                           const std::string& where) {
    const Attributes attributes = findAttributes(primitive, uv, where);
    SourcePrimitive source;
    source.mesh.name = where;
    source.fileVertexCount = attributes.position->count();
    source.mesh.indices = triangleList(primitive, m_accessors, attributes.position->count(), where);
    if (source.mesh.indices.empty()) {
        m_notes.add("a primitive has no triangles", where);
        return std::nullopt;
    }
    if (attributes.normal == nullptr) {
        addFlat(source, attributes, where);
    } else {
        addShared(source, attributes, where);
    }
    if (uv.tangents != UvPlaces::Tangents::none && attributes.tangent == nullptr) {
        const std::vector<std::uint32_t> before = source.mesh.indices;
        addTangents(source.mesh, primitive, uv.tangents, where);
        source.derived = uv.tangents;
        source.fileVertices.resize(source.mesh.vertices.size());
        for (std::size_t i = 0; i < before.size(); ++i) { // a vertex may have become several
            source.fileVertices[source.mesh.indices[i]] = source.fileVertices[before[i]];
        }
    }
    return source;
}

void MeshImporter::addTangents(SourceMesh& mesh, const Primitive& primitive, UvPlaces::Tangents along,
                               const std::string& where) {
    const std::uint64_t spare =
        m_memory.leftBeside(predictBytes(primitive, m_accessors, VertexKind::detailed));
    if (const std::optional<std::string> reason = deriveMikkTSpaceTangents(mesh, along, spare)) {
        m_notes.add(fmt::format("its tangents are not MikkTSpace's: {}", *reason), where);
        deriveTangents(mesh, along);
    }
}

std::optional<SourcePrimitive> MeshImporter::readSolids(const Primitive& primitive, const UvPlaces& uv,
                                                        std::optional<double> radius,
                                                        const std::string& where) {
    const Attributes attributes = findAttributes(primitive, uv, where);
    const std::size_t vertexCount = attributes.position->count();
    const std::vector<SolidEnds> solids = solidList(primitive, m_accessors, vertexCount, where);
    if (!radius) {
        const glm::dvec3 sides = sidesOf(solids, *attributes.position, where);
        radius = primitive.mode == kModePoints ? defaultPointRadius(sides, solids.size())
                                               : defaultLineRadius(sides);
    }
    if (solids.empty() || !(*radius > 0.0)) {
        m_notes.add(solids.empty() ? "a primitive has no points or lines"
                                   : "its points or lines are all at one place, so their size is not known",
                    where);
        return std::nullopt;
    }
    SourcePrimitive source;
    source.mesh.name = where;
    source.fileVertexCount = vertexCount;
    source.mesh.vertices.reserve(solids.size() * kSolidCorners);
    source.mesh.details.reserve(uv.hasDetail() ? solids.size() * kSolidCorners : 0);
    source.mesh.positions.reserve(solids.size() * kSolidCorners);
    source.mesh.indices.reserve(solids.size() * kSolidIndices.size());
    source.fileVertices.reserve(solids.size() * kSolidCorners);
    for (const SolidEnds& ends : solids) {
        addSolid(source, attributes, ends, *radius, where);
    }
    if (source.mesh.indices.empty()) {
        m_notes.add("its lines have no length", where);
        return std::nullopt;
    }
    return source;
}

void MeshImporter::addSolid(SourcePrimitive& source, const Attributes& attributes, const SolidEnds& ends,
                            double radius, const std::string& where) {
    SourceMesh& mesh = source.mesh;
    const std::array vertices{readVertex(attributes, ends.first, where),
                              readVertex(attributes, ends.second, where)};
    const glm::dvec3 along = glm::dvec3(vertices[1].position) - glm::dvec3(vertices[0].position);
    const bool isPoint = ends.first == ends.second;
    if (!isPoint && along == glm::dvec3(0.0)) {
        return; // nothing of a line is seen that has no length
    }
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const SolidShape shape = isPoint ? pointShape() : segmentShape(along);
    for (std::size_t i = 0; i < shape.size(); ++i) {
        Vertex vertex = vertices[i / 3];
        mesh.positions.push_back(glm::dvec3(vertex.position) + radius * shape[i]);
        vertex.position = glm::vec3(mesh.positions.back());
        if (!isFinite(vertex.position)) {
            refuse("{}: its extent is over what a float32 holds", where);
        }
        if (attributes.normal == nullptr) {
            vertex.normal = glm::vec3(shape[i]);
        }
        const std::uint32_t fileVertex = i < 3 ? ends.first : ends.second;
        if (attributes.places.hasDetail()) {
            mesh.details.push_back(readDetail(attributes, fileVertex, vertex.normal, where));
        }
        mesh.vertices.push_back(vertex);
        source.fileVertices.push_back(fileVertex);
    }
    for (const std::uint32_t index : kSolidIndices) {
        mesh.indices.push_back(first + index);
    }
}

std::vector<MeshPiece> MeshImporter::import(const Primitive& primitive, const UvPlaces& uv,
                                            const MeshSizes& sizes, const std::string& where) {
    std::optional<SourcePrimitive> source = read(primitive, uv, sizes.pointRadius, where);
    if (!source) {
        return {};
    }
    source->fileVertices = std::vector<std::uint32_t>(); // of use for what deforms alone
    std::vector<MeshPiece> pieces = cutIntoPieces(std::move(source->mesh), sizes.pieceRadius);
    for (const MeshPiece& piece : pieces) {
        requireUsable(std::span<const Vertex>(), piece.mesh.boundingRadius, where);
    }
    if (pieces.size() == 1 && pieces.front().mesh.boundingRadius == 0.0f) {
        m_notes.add("a primitive has no extent", where);
        return {};
    }
    return pieces;
}

MeshImporter::Attributes MeshImporter::findAttributes(const Primitive& primitive, const UvPlaces& uv,
                                                      const std::string& where) {
    const auto find = [&](const std::string& name, int fewest, int most) -> const Accessor* {
        const Accessor* accessor = attributeOf(primitive, name, m_accessors);
        if (accessor != nullptr && (accessor->components() < fewest || accessor->components() > most)) {
            refuse("{}: {} has {} components", where, name, accessor->components());
        }
        return accessor;
    };
    const auto findUv = [&](const std::optional<UvSource>& place) {
        return find(fmt::format("TEXCOORD_{}", place.value_or(UvSource{}).texCoord), 2, 2);
    };
    Attributes attributes{.position = find("POSITION", 3, 3),
                          .normal = find("NORMAL", 3, 3),
                          .uv = findUv(uv.first),
                          .color = find("COLOR_0", 3, 4),
                          .secondUv = uv.second ? findUv(uv.second) : nullptr,
                          .places = uv};
    // glTF: without normals, tangents do not count.
    if (uv.tangents != UvPlaces::Tangents::none && attributes.normal != nullptr) {
        attributes.tangent = find("TANGENT", 4, 4);
    }
    for (const Accessor* accessor :
         {attributes.normal, attributes.uv, attributes.color, attributes.secondUv, attributes.tangent}) {
        if (accessor != nullptr && accessor->count() != attributes.position->count()) {
            refuse("{}: an attribute has {} elements for {} positions", where, accessor->count(),
                   attributes.position->count());
        }
    }
    return attributes;
}

Vertex MeshImporter::readVertex(const Attributes& attributes, std::uint32_t index, const std::string& where) {
    Vertex vertex;
    vertex.position = glm::vec3(attributes.position->vector(index));
    requireFinite(vertex.position, index, where);
    if (attributes.normal != nullptr) {
        const std::optional<glm::vec3> normal = normalized(glm::dvec3(attributes.normal->vector(index)));
        if (!normal) {
            m_notes.add("a normal has no direction, so +z is used", where);
        }
        vertex.normal = normal.value_or(kAnyNormal);
    }
    if (attributes.uv != nullptr) {
        vertex.uv = attributes.places.first.value_or(UvSource{}).apply(attributes.uv->vector(index));
    }
    if (attributes.color != nullptr) {
        const glm::vec4 color = attributes.color->vector(index);
        vertex.color = {toUnorm8(color.r), toUnorm8(color.g), toUnorm8(color.b), toUnorm8(color.a)};
    }
    return vertex;
}

VertexDetail MeshImporter::readDetail(const Attributes& attributes, std::uint32_t index,
                                      const glm::vec3& normal, const std::string& where) {
    VertexDetail detail;
    if (attributes.secondUv != nullptr) {
        detail.uv = attributes.places.second->apply(attributes.secondUv->vector(index));
    }
    if (attributes.tangent != nullptr) {
        const glm::vec4 read = attributes.tangent->vector(index);
        const std::optional<glm::vec3> tangent = normalized(glm::dvec3(read));
        if (!tangent) {
            m_notes.add("a tangent has no direction, so any is used", where);
        }
        detail.tangent = glm::vec4(tangent.value_or(anyTangent(normal)), read.w < 0.0f ? -1.0f : 1.0f);
    }
    return detail;
}

void MeshImporter::addVertices(SourceMesh& mesh, const Attributes& attributes,
                               std::span<const std::uint32_t> indices, const std::string& where) {
    const bool hasDetail = attributes.places.hasDetail();
    const std::vector<std::uint32_t> order =
        readingOrder(indices, bytesApartInFile({attributes.position, attributes.normal, attributes.uv,
                                                attributes.color, attributes.secondUv, attributes.tangent}));
    mesh.vertices.resize(indices.size());
    mesh.details.resize(hasDetail ? indices.size() : 0);
    forEachInOrder(order, indices.size(), [&](std::uint32_t i) {
        mesh.vertices[i] = readVertex(attributes, indices[i], where);
        if (hasDetail) {
            mesh.details[i] = readDetail(attributes, indices[i], mesh.vertices[i].normal, where);
        }
    });
}

void MeshImporter::addShared(SourcePrimitive& source, const Attributes& attributes,
                             const std::string& where) {
    if (m_newIndex.size() < attributes.position->count()) {
        m_newIndex.resize(attributes.position->count(), kUnused);
    }
    SourceMesh& mesh = source.mesh;
    std::vector<std::uint32_t>& used = source.fileVertices;
    used.reserve(std::min(attributes.position->count(), mesh.indices.size()));
    for (std::uint32_t& index : mesh.indices) {
        if (m_newIndex[index] == kUnused) {
            m_newIndex[index] = static_cast<std::uint32_t>(used.size());
            used.push_back(index);
        }
        index = m_newIndex[index];
    }
    addVertices(mesh, attributes, used, where);
    for (const std::uint32_t index : used) {
        m_newIndex[index] = kUnused;
    }
}

void MeshImporter::addFlat(SourcePrimitive& source, const Attributes& attributes, const std::string& where) {
    SourceMesh& mesh = source.mesh;
    source.fileVertices = mesh.indices;
    addVertices(mesh, attributes, source.fileVertices, where);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
        const glm::dvec3 a(mesh.vertices[i].position);
        const glm::dvec3 b(mesh.vertices[i + 1].position);
        const glm::dvec3 c(mesh.vertices[i + 2].position);
        const glm::vec3 normal = normalized(glm::cross(b - a, c - a)).value_or(kAnyNormal);
        mesh.vertices[i].normal = mesh.vertices[i + 1].normal = mesh.vertices[i + 2].normal = normal;
    }
}

} // namespace cdr::scene::gltf
