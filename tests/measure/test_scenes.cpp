#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace cdr::test {

namespace {

/// The 12 corners and 20 faces of an icosahedron.
void addIcosahedron(std::vector<glm::vec3>& corners, std::vector<std::uint32_t>& indices) {
    const float golden = (1.0f + std::sqrt(5.0f)) / 2.0f;
    for (const float a : {-1.0f, 1.0f}) {
        for (const float b : {-golden, golden}) {
            for (const glm::vec3& corner : {glm::vec3(0, a, b), glm::vec3(a, b, 0), glm::vec3(b, 0, a)}) {
                corners.push_back(glm::normalize(corner));
            }
        }
    }
    // Faces are the triples of mutually nearest corners.
    const float edge = 2.0f / std::sqrt(1.0f + golden * golden) * 1.01f;
    for (std::uint32_t i = 0; i < 12; ++i) {
        for (std::uint32_t j = i + 1; j < 12; ++j) {
            for (std::uint32_t k = j + 1; k < 12; ++k) {
                const glm::vec3& a = corners[i];
                const glm::vec3& b = corners[j];
                const glm::vec3& c = corners[k];
                if (glm::distance(a, b) < edge && glm::distance(b, c) < edge && glm::distance(c, a) < edge) {
                    const bool outward = glm::dot(glm::cross(b - a, c - a), a) > 0.0f;
                    indices.insert(indices.end(), {i, outward ? j : k, outward ? k : j});
                }
            }
        }
    }
}

void subdivide(std::vector<glm::vec3>& corners, std::vector<std::uint32_t>& indices) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [entry, isNew] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(corners.size()));
        if (isNew) {
            const glm::vec3 point = glm::normalize(corners[a] + corners[b]);
            corners.push_back(point);
        }
        return entry->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const std::uint32_t a = indices[i];
        const std::uint32_t b = indices[i + 1];
        const std::uint32_t c = indices[i + 2];
        const std::uint32_t ab = middle(a, b);
        const std::uint32_t bc = middle(b, c);
        const std::uint32_t ca = middle(c, a);
        finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
    }
    indices = std::move(finer);
}

} // namespace

scene::Mesh makeIcosphere(int level) {
    std::vector<glm::vec3> corners;
    scene::Mesh mesh;
    mesh.name = "icosphere";
    mesh.boundingRadius = 1.0f;
    addIcosahedron(corners, mesh.indices);
    for (int i = 0; i < level; ++i) {
        subdivide(corners, mesh.indices);
    }
    for (const glm::vec3& corner : corners) {
        mesh.vertices.push_back({.position = corner, .normal = corner});
    }
    return mesh;
}

scene::Scene makeEmptyScene() {
    scene::Scene scene;
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    scene.meshes.push_back(scene.meshes[kCube]);
    scene.meshes[kTriangleCube].boxHalfSides.reset();
    scene.meshes.push_back(makeIcosphere(1));
    scene.materials.resize(2);
    scene.materials[kDoubleSided].doubleSided = true;
    return scene;
}

std::uint32_t addObject(scene::Scene& scene, std::uint32_t mesh, const glm::dvec3& position,
                        const glm::mat3& basis, std::uint32_t material) {
    const std::uint32_t object = scene.objectCount();
    scene::addInstance(scene, mesh, material, object, position, basis);
    return object;
}

glm::mat3 randomRotation(std::mt19937_64& random) {
    std::normal_distribution<float> normal;
    const auto direction = [&] {
        const float x = normal(random);
        const float y = normal(random);
        return glm::normalize(glm::vec3(x, y, normal(random)));
    };
    const glm::vec3 a = direction();
    const glm::vec3 b = glm::normalize(glm::cross(a, direction()));
    return {a, b, glm::cross(a, b)};
}

scene::Scene makeRandomScene(std::uint64_t seed, std::uint32_t objects, double side,
                             const glm::dvec3& centre) {
    scene::Scene scene = makeEmptyScene();
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-0.5 * side, 0.5 * side);
    std::uniform_real_distribution<float> scale(0.5f, 3.0f);
    for (std::uint32_t object = 0; object < objects; ++object) {
        glm::mat3 basis = randomRotation(random);
        for (int axis = 0; axis < 3; ++axis) {
            basis[axis] *= scale(random) * (random() % 4 == 0 ? -1.0f : 1.0f);
        }
        if (random() % 4 == 0) {
            basis[0] += 0.5f * basis[1];
        }
        const double x = place(random);
        const double y = place(random);
        const auto mesh = static_cast<std::uint32_t>(random() % 3);
        const auto material = static_cast<std::uint32_t>(random() % 2);
        addObject(scene, mesh, centre + glm::dvec3(x, y, place(random)), basis, material);
    }
    return scene;
}

scene::Camera makeCameraAround(std::mt19937_64& random, const glm::dvec3& target, double distance,
                               double height) {
    scene::Camera camera;
    camera.fovY = 2.0 * std::atan(0.5 * height / distance);
    camera.nearView = 1e-4 * distance;
    camera.farView = 2.0 * distance + 100.0;
    return scene::lookAt(camera, target + distance * glm::dvec3(randomRotation(random)[0]), target);
}

scene::Camera makePlainCamera() {
    scene::Camera camera;
    camera.fovY = 60.0 * kDegree;
    camera.nearView = 0.1;
    camera.farView = 1000.0;
    return camera;
}

measure::TruthImage cast(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                         std::uint32_t height) {
    platform::WorkerPool workers(1);
    return measure::castTruth(scene, camera, width, height, workers);
}

measure::TruthPixel castMiddle(const scene::Scene& scene, const scene::Camera& camera) {
    return cast(scene, camera, 1, 1).at(0, 0);
}

} // namespace cdr::test
