#pragma once

#include <cdr/scene/animation/mesh_pose.h>
#include <cdr/scene/world/world.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace cdr::test {

/// Numbers that are the same with every library.
class Random {
  public:
    explicit Random(std::uint32_t seed) : m_engine(seed) {}

    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(m_engine()) % end; }
    float within(float size) { return size * (2.0f * static_cast<float>(m_engine()) / 4294967296.0f - 1.0f); }
    glm::vec3 vector(float size) {
        const float x = within(size);
        const float y = within(size);
        return {x, y, within(size)};
    }

  private:
    std::mt19937 m_engine;
};

/// What a deformer of a test is like.
struct DeformerKind {
    std::string name;
    std::uint32_t joints = 0;
    std::uint32_t targets = 0;
    bool isFlat = false;
    bool derivedTangents = false;
    bool mirrors = false;
};

inline std::vector<DeformerKind> deformerKinds() {
    return {{.name = "skin", .joints = 300},
            {.name = "morph targets", .targets = 7},
            {.name = "both", .joints = 40, .targets = 5, .derivedTangents = true},
            {.name = "flat", .joints = 20, .targets = 3, .isFlat = true},
            {.name = "mirror", .joints = 3, .mirrors = true}};
}

/// Triangles anywhere in a cube, with details.
inline std::shared_ptr<const scene::Deformer> makeDeformer(const DeformerKind& kind, std::uint32_t seed) {
    constexpr std::uint32_t kVertices = 333;
    Random random(seed);
    auto deformer = std::make_shared<scene::Deformer>();
    deformer->isFlat = kind.isFlat;
    deformer->derivedTangents = kind.derivedTangents;
    for (std::uint32_t i = 0; i < kVertices; ++i) {
        deformer->vertices.push_back({.position = random.vector(2.0f),
                                      .normal = glm::normalize(random.vector(1.0f)),
                                      .uv = {0.5f, 0.25f}});
        deformer->details.push_back(
            {.tangent = glm::vec4(glm::normalize(random.vector(1.0f)), i % 2 == 0 ? 1.0f : -1.0f)});
    }
    for (std::uint32_t i = 0; kind.joints > 0 && i <= kVertices; ++i) {
        deformer->firstInfluence.push_back(deformer->influences.size());
        const std::uint32_t count = i < kVertices ? 1 + random.below(12) : 0;
        for (std::uint32_t k = 0; k < count; ++k) {
            deformer->influences.push_back(
                {.joint = random.below(kind.joints), .weight = 1.0f / static_cast<float>(count)});
        }
    }
    for (std::uint32_t target = 0; target < kind.targets; ++target) {
        std::vector<scene::MorphDelta>& deltas = deformer->targets.emplace_back();
        for (std::uint32_t i = target; i < kVertices; i += 2 + target) {
            deltas.push_back({.vertex = i,
                              .position = random.vector(0.5f),
                              .normal = random.vector(0.5f),
                              .tangent = random.vector(0.5f)});
        }
    }
    finish(*deformer);
    return deformer;
}

/// A pose of it, about a point far from the origin.
inline scene::MeshPose poseOf(const DeformerKind& kind,
                              const std::shared_ptr<const scene::Deformer>& deformer, std::uint32_t seed) {
    Random random(seed);
    scene::MeshPose pose{.deformer = deformer, .weights = {}, .joints = {}, .place = {}};
    for (std::uint32_t i = 0; i < kind.targets; ++i) {
        pose.weights.push_back(i == seed % 3 ? 0.0 : static_cast<double>(random.within(1.0f)));
    }
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), glm::dvec3(1e6, -3e5, 2e5));
    for (std::uint32_t i = 0; i < kind.joints; ++i) {
        glm::dmat4 joint = glm::translate(away, glm::dvec3(random.vector(0.7f)));
        joint = glm::rotate(joint, static_cast<double>(random.within(1.0f)), glm::dvec3(random.vector(1.0f)));
        pose.joints.push_back(
            glm::scale(joint, glm::dvec3(kind.mirrors ? -1.0 : 1.0,
                                         1.0 + 0.2 * static_cast<double>(random.within(1.0f)), 1.0)));
    }
    pose.place = pose.joints.empty() ? placeOf(*deformer, away) : placeOf(*deformer, pose.joints);
    return pose;
}

/// What the CPU makes of a pose.
inline scene::MeshVertices deformedByCpu(const scene::MeshPose& pose) {
    const std::size_t count = pose.deformer->vertices.size();
    scene::MeshVertices made{.vertices = std::vector<scene::Vertex>(count),
                             .details = std::vector<scene::VertexDetail>(pose.deformer->details.size())};
    deform(*pose.deformer, pose.deformation(), 0, count, made);
    setFlatNormals(*pose.deformer, made.vertices);
    return made;
}

} // namespace cdr::test
