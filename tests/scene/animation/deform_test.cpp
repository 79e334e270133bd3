#include <cdr/scene/animation/deform.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace cdr::scene {

namespace {

constexpr double kFar = 1e6;

/// A corner each of two joints, and one of both in equal parts.
Deformer threeCorners() {
    Deformer deformer;
    for (const glm::vec3 position :
         {glm::vec3(0.0f), glm::vec3(2.0f, 0.0f, 0.0f), glm::vec3(0.0f, 2.0f, 0.0f)}) {
        deformer.vertices.push_back({.position = position, .normal = {0.0f, 0.0f, 1.0f}});
    }
    deformer.firstInfluence = {0, 1, 2, 4};
    deformer.influences = {{0, 1.0f}, {1, 1.0f}, {0, 0.5f}, {1, 0.5f}};
    finish(deformer);
    return deformer;
}

MeshVertices deformedBy(const Deformer& deformer, const Deformation& deformation) {
    MeshVertices deformed{std::vector<Vertex>(deformer.vertices.size()),
                          std::vector<VertexDetail>(deformer.details.size())};
    deform(deformer, deformation, 0, deformed.vertices.size(), deformed);
    setFlatNormals(deformer, deformed.vertices);
    return deformed;
}

std::vector<Vertex> deformedBy(const Deformer& deformer, const std::vector<double>& weights,
                               const std::vector<glm::dmat4>& joints, const DeformedPlace& place) {
    return deformedBy(deformer, {.weights = weights, .joints = joints, .place = place}).vertices;
}

glm::dvec3 worldOf(const DeformedPlace& place, const Vertex& vertex) {
    return place.position + place.basis * glm::dvec3(vertex.position);
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double most) {
    EXPECT_LE(glm::length(a - b), most)
        << a.x << " " << a.y << " " << a.z << ", not " << b.x << " " << b.y << " " << b.z;
}

/// A model far from the origin keeps float32's exactness about itself.
TEST(Deform, VerticesFollowTheirJoints) {
    const Deformer deformer = threeCorners();
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), glm::dvec3(kFar, 0.0, 0.0));
    const glm::dmat4 turned = away * glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(1.0, 0.0, 0.0));
    const std::vector<glm::dmat4> joints{away, turned};
    const DeformedPlace place = placeOf(deformer, joints);
    const std::vector<Vertex> vertices = deformedBy(deformer, {}, joints, place);
    expectNear(worldOf(place, vertices[0]), {kFar, 0.0, 0.0}, 1e-6);
    expectNear(worldOf(place, vertices[1]), {kFar + 2.0, 0.0, 0.0}, 1e-6);
    expectNear(worldOf(place, vertices[2]), {kFar, 1.0 + std::cos(0.5), std::sin(0.5)}, 1e-6);
    expectNear(glm::dvec3(vertices[1].normal), {0.0, -std::sin(0.5), std::cos(0.5)}, 1e-6);
}

/// Normals of a joint that stretches turn away from where it does.
TEST(Deform, NormalsStayAcrossSurfacesThatStretch) {
    Deformer deformer = threeCorners();
    deformer.vertices[0].normal = glm::normalize(glm::vec3(1.0f, 1.0f, 0.0f));
    const std::vector<glm::dmat4> joints(2, glm::scale(glm::dmat4(1.0), glm::dvec3(3.0, 1.0, 1.0)));
    const std::vector<Vertex> vertices = deformedBy(deformer, {}, joints, placeOf(deformer, joints));
    expectNear(glm::dvec3(vertices[0].normal), glm::normalize(glm::dvec3(1.0, 3.0, 0.0)), 1e-6);
}

/// A mirror makes an instance that mirrors, so that fronts stay fronts.
TEST(Deform, JointsThatMirrorKeepFronts) {
    const Deformer deformer = threeCorners();
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, -1.0));
    const std::vector<glm::dmat4> joints(2, mirror);
    const DeformedPlace place = placeOf(deformer, joints);
    EXPECT_LT(glm::determinant(place.basis), 0.0);
    const std::vector<Vertex> vertices = deformedBy(deformer, {}, joints, place);
    for (std::size_t i = 0; i < 3; ++i) {
        expectNear(worldOf(place, vertices[i]),
                   glm::dvec3(mirror * glm::dvec4(glm::dvec3(deformer.vertices[i].position), 1.0)), 1e-6);
    }
    expectNear(place.basis * glm::dvec3(vertices[0].normal), {0.0, 0.0, -1.0}, 1e-6);
}

TEST(Deform, MorphTargetsAddUp) {
    Deformer deformer = threeCorners();
    deformer.firstInfluence.clear();
    deformer.influences.clear();
    deformer.isFlat = true;
    deformer.targets = {
        {{.vertex = 1, .position = {2.0f, 0.0f, 0.0f}}},
        {{.vertex = 1, .position = {0.0f, 0.0f, 1.0f}}, {.vertex = 2, .position = {0.0f, 4.0f, 0.0f}}}};
    const DeformedPlace place = placeOf(deformer, glm::dmat4(1.0));
    const std::vector<Vertex> vertices = deformedBy(deformer, {0.5, 2.0}, {}, place);
    expectNear(worldOf(place, vertices[0]), {0.0, 0.0, 0.0}, 1e-6);
    expectNear(worldOf(place, vertices[1]), {3.0, 0.0, 2.0}, 1e-6);
    expectNear(worldOf(place, vertices[2]), {0.0, 10.0, 0.0}, 1e-6);
    expectNear(glm::dvec3(vertices[2].normal), glm::normalize(glm::dvec3(-2.0, 0.0, 3.0)), 1e-6);
}

/// Workers deform a part each.
TEST(Deform, PartsAreThoseOfTheWhole) {
    Deformer deformer = threeCorners();
    deformer.targets = {
        {{.vertex = 0, .position = {1.0f, 0.0f, 0.0f}}, {.vertex = 2, .position = {0.0f, 4.0f, 0.0f}}}};
    const std::vector<glm::dmat4> joints(2, glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(0.0, 1.0, 0.0)));
    const DeformedPlace place = placeOf(deformer, joints);
    const std::vector<double> weights{0.75};
    const std::vector<Vertex> whole = deformedBy(deformer, weights, joints, place);
    MeshVertices parts{std::vector<Vertex>(3), {}};
    for (std::size_t i = 0; i < 3; ++i) {
        deform(deformer, {.weights = weights, .joints = joints, .place = place}, i, i + 1, parts);
        EXPECT_EQ(parts.vertices[i].position, whole[i].position);
        EXPECT_EQ(parts.vertices[i].normal, whole[i].normal);
    }
}

/// Like the edges that they lie along: the bitangent is where a texture's v grows.
TEST(Deform, TangentsStayAlongTheSurface) {
    Deformer deformer = threeCorners();
    deformer.details.assign(3, {.tangent = {1.0f, 0.0f, 0.0f, -1.0f}, .uv = {0.25f, 0.5f}});
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(0.0, 0.0, 1.0));
    const glm::dmat4 shear(glm::dvec4(1.0, 0.5, 0.0, 0.0), glm::dvec4(0.0, 1.0, 0.0, 0.0),
                           glm::dvec4(0.0, 0.0, 1.0, 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0));
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, -1.0, 1.0));
    for (const glm::dmat4& joint : {turn, shear, mirror}) {
        const std::vector<glm::dmat4> joints(2, joint);
        const DeformedPlace place = placeOf(deformer, joints);
        const MeshVertices deformed = deformedBy(deformer, {.weights = {}, .joints = joints, .place = place});
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 tangent(deformed.details[i].tangent);
            const double sense = deformed.details[i].tangent.w * glm::determinant(place.basis);
            const glm::dvec3 normal(deformed.vertices[i].normal);
            expectNear(place.basis * tangent, glm::normalize(glm::dvec3(joint[0])), 1e-6);
            const glm::dvec3 bitangent = sense * glm::cross(place.basis * normal, place.basis * tangent);
            EXPECT_GT(glm::dot(bitangent, glm::dvec3(joint * glm::dvec4(0.0, -1.0, 0.0, 0.0))), 0.5);
            EXPECT_EQ(deformed.details[i].uv, deformer.details[i].uv);
        }
    }
}

/// One joint mirrors, and the other does not: so does the instance.
TEST(Deform, TangentsOfAJointThatMirrorsAloneAreTurnedRound) {
    Deformer deformer = threeCorners();
    deformer.details.assign(3, VertexDetail{});
    deformer.firstInfluence = {0, 1, 2, 3};
    deformer.influences = {{0, 1.0f}, {0, 1.0f}, {1, 1.0f}};
    finish(deformer);
    const std::vector<glm::dmat4> joints{glm::dmat4(1.0),
                                         glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, -1.0, 1.0))};
    const MeshVertices deformed =
        deformedBy(deformer, {.weights = {}, .joints = joints, .place = placeOf(deformer, joints)});
    EXPECT_EQ(deformed.details[0].tangent, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(deformed.details[2].tangent, glm::vec4(1.0f, 0.0f, 0.0f, -1.0f));
}

TEST(Deform, MorphTargetsTurnTangents) {
    Deformer deformer = threeCorners();
    deformer.firstInfluence.clear();
    deformer.influences.clear();
    deformer.details.assign(3, VertexDetail{});
    deformer.targets = {{{.vertex = 1, .tangent = {0.0f, 2.0f, 0.0f}}}};
    const std::vector<double> weights{0.5};
    const MeshVertices deformed =
        deformedBy(deformer, {.weights = weights, .joints = {}, .place = placeOf(deformer, glm::dmat4(1.0))});
    EXPECT_EQ(deformed.details[0].tangent, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    expectNear(glm::dvec3(deformed.details[1].tangent), glm::normalize(glm::dvec3(1.0, 1.0, 0.0)), 1e-6);
}

} // namespace

} // namespace cdr::scene
