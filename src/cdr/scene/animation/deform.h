#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::scene {

/// How far a morph target moves a vertex.
struct MorphDelta {
    std::uint32_t vertex = 0; ///< into Deformer::vertices
    glm::vec3 position{0.0f}; ///< what is added to Vertex::position at a weight of one
    glm::vec3 normal{0.0f};   ///< the same for Vertex::normal
    glm::vec3 tangent{0.0f};  ///< of VertexDetail::tangent, whose w stays
};

/// A joint that a vertex follows.
struct Influence {
    std::uint32_t joint = 0; ///< into the skin's joints
    float weight = 0.0f;     ///< those of a vertex add up to one
};

/// Where the vertices are that a joint moves, before it does.
struct JointReach {
    std::uint32_t joint = 0; ///< into the skin's joints
    glm::dvec3 centre{0.0};  ///< of the box about these vertices
    double radius = 0.0;     ///< of the sphere about them, at that centre
};

/// A mesh that morph targets and joints deform, as it is before they do.
struct Deformer {
    std::vector<Vertex> vertices;      ///< about the mesh's origin
    std::vector<VertexDetail> details; ///< one per vertex, or empty
    bool isFlat = false; ///< three vertices for each triangle in turn, whose normal follows from its corners
    bool derivedTangents = false; ///< tangents that morph targets keep at a right angle to normals
    std::vector<std::vector<MorphDelta>> targets; ///< only vertices that they move, ascending, each once
    /// By vertex, from 0, and the end, which is influences.size(); empty without a skin.
    std::vector<std::size_t> firstInfluence;
    std::vector<Influence> influences;    ///< vertex by vertex
    glm::dvec3 centre{0.0};               ///< of its bounding box
    std::uint32_t anchor = 0;             ///< with a skin: the joint that most of it follows
    double reach = 0.0;                   ///< largest distance of a vertex from `centre`
    std::vector<double> targetReach;      ///< how far each morph target moves a vertex at most
    std::vector<JointReach> jointReaches; ///< of joints that move vertices, ascending
    double weightError = 0.0;             ///< by how much the weights of a vertex miss a sum of one at most
    double weightSize = 1.0; ///< what the weights of a vertex add up to at most, all taken as positive
};

/// Whether finish() takes it.
CDR_EXPORT bool hasInfluencesByVertex(const Deformer& deformer);

/// Fills in `centre` and all that follows it.
/// @throws base::InputError unless `firstInfluence` divides `influences` among the vertices, or both are empty.
CDR_EXPORT void finish(Deformer& deformer);

/// Where a deformed mesh stands, and from what its vertices are counted.
struct DeformedPlace {
    glm::dvec3 position{0.0}; ///< world space, of the origin of the deformed mesh
    glm::dmat3 basis{1.0};    ///< object to world; with joints the identity, or a mirror along x
};

/// By morph targets alone the mesh deforms in its own space, and its node carries it.
CDR_EXPORT DeformedPlace placeOf(const Deformer& deformer, const glm::dmat4& toWorld);
/// With a skin its node carries nothing. Vertices are worked out in world space, about a point that goes with a joint, so
/// that float32 holds them wherever the model is.
/// @param joints world space, by joint: where it is now, times its inverse bind matrix
CDR_EXPORT DeformedPlace placeOf(const Deformer& deformer, std::span<const glm::dmat4> joints);

/// What deforms a mesh at a moment, and where the mesh stands then.
struct Deformation {
    std::span<const double> weights;    ///< of the morph targets
    std::span<const glm::dmat4> joints; ///< as placeOf() takes them; empty without a skin
    DeformedPlace place;                ///< where it stands
};

/// Vertices `first` to `last` of the deformed mesh about its place, all in float64 until they are rounded once. Normals
/// stay across the surface, and tangents along it.
/// @param deformer that requireUsable() lets pass (mesh_pose.h)
/// @param deformed with room for all vertices, and for all details where the deformer has them
CDR_EXPORT void deform(const Deformer& deformer, const Deformation& deformation, std::size_t first,
                       std::size_t last, MeshVertices& deformed);

/// Gives the triangles of a flat mesh their normals; after all vertices were deformed.
CDR_EXPORT void setFlatNormals(const Deformer& deformer, std::span<Vertex> deformed);

} // namespace cdr::scene
