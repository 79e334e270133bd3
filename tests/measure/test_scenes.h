#pragma once

#include <cdr/measure/truth/truth.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <random>

namespace cdr::test {

inline constexpr double kDegree = 0.017453292519943295;

/// A unit icosphere: 20 * 4^level triangles that share their corners.
scene::Mesh makeIcosphere(int level);

/// No objects. Meshes: 0 a unit cube, 1 the same cube as triangles only, 2 an icosphere of 80 triangles.
/// Materials: 0 single-sided, 1 double-sided.
scene::Scene makeEmptyScene();
inline constexpr std::uint32_t kCube = 0;
inline constexpr std::uint32_t kTriangleCube = 1;
inline constexpr std::uint32_t kIcosphere = 2;
inline constexpr std::uint32_t kSingleSided = 0;
inline constexpr std::uint32_t kDoubleSided = 1;

/// Adds an object of its own; returns its index.
std::uint32_t addObject(scene::Scene& scene, std::uint32_t mesh, const glm::dvec3& position,
                        const glm::mat3& basis = glm::mat3(1.0f), std::uint32_t material = kSingleSided);

glm::mat3 randomRotation(std::mt19937_64& random);

/// Rotated, scaled, sheared and mirrored objects of every mesh and material of makeEmptyScene in a cube of
/// the given side about `centre`.
scene::Scene makeRandomScene(std::uint64_t seed, std::uint32_t objects, double side,
                             const glm::dvec3& centre);

/// From `distance` away in a random direction, with the lens that shows `height` units there.
scene::Camera makeCameraAround(std::mt19937_64& random, const glm::dvec3& target, double distance,
                               double height);

/// At the origin, looking along -z, 60 degrees, near 0.1, far 1000.
scene::Camera makePlainCamera();

/// The truth on one thread.
measure::TruthImage cast(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                         std::uint32_t height);

/// What the middle of the picture shows.
measure::TruthPixel castMiddle(const scene::Scene& scene, const scene::Camera& camera);

} // namespace cdr::test
