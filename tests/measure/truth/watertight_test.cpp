#include "../test_scenes.h"

#include <cdr/measure/truth/triangle_bvh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cdr::test {

namespace {

using measure::ObjectRay;
using measure::TriangleBvh;
using measure::ViewRange;

constexpr ViewRange kAll{1e-9, 1e30};

/// The radius of the largest sphere about the origin inside a convex mesh.
double innerRadius(const scene::Mesh& mesh) {
    double least = 1.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position);
        };
        const glm::dvec3 normal = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
        least = std::min(least, glm::dot(normal, corner(0)));
    }
    return least;
}

/// Rays at every corner and every edge's middle of `mesh` that faces `eye`; returns how many there are, and
/// expects each to hit.
int expectNoLeak(const scene::Mesh& mesh, const glm::dvec3& eye) {
    const TriangleBvh bvh(mesh);
    int rays = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const glm::dvec3 a(mesh.vertices[mesh.indices[i]].position);
        const glm::dvec3 b(mesh.vertices[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]].position);
        for (const glm::dvec3& aim : {a, 0.5 * (a + b), 0.25 * a + 0.75 * b}) {
            const glm::dvec3 direction = aim - eye;
            if (glm::dot(aim, direction) < -0.2 * glm::length(direction)) {
                ++rays;
                const double hit = bvh.nearest(ObjectRay{eye, direction}, measure::Sidedness::fronts, kAll);
                EXPECT_NEAR(hit, 1.0, 1e-9) << "leak at index " << i;
            }
        }
    }
    return rays;
}

} // namespace

TEST(Watertight, NoRayPassesBetweenTrianglesThatShareAnEdge) {
    std::mt19937_64 random(5);
    const scene::Mesh mesh = makeIcosphere(4);
    int rays = 0;
    for (const double distance : {1.5, 10.0, 1e3, 1e6}) {
        for (int i = 0; i < 4; ++i) {
            rays += expectNoLeak(mesh, distance * glm::dvec3(randomRotation(random)[0]));
        }
        // Along an axis many edge functions are exactly 0.
        rays += expectNoLeak(mesh, {distance, 0.0, 0.0});
        rays += expectNoLeak(mesh, {0.0, 0.0, -distance});
    }
    std::printf("%d rays at corners and edges\n", rays);
    EXPECT_GT(rays, 10'000);
}

TEST(Watertight, NoBackgroundInsideADenseSpheresSilhouette) {
    scene::Scene scene = makeEmptyScene();
    scene.meshes.push_back(makeIcosphere(6));
    const double inner = innerRadius(scene.meshes[3]);
    std::mt19937_64 random(9);
    int inside = 0;
    for (const double distance : {1.2, 3.0, 1e4, 1e7}) {
        scene.instances = {};
        const glm::dvec3 centre(10.0, -3.0, distance);
        addObject(scene, 3, centre, randomRotation(random));
        const scene::Camera camera = makeCameraAround(random, centre, distance, 2.2);
        const measure::TruthImage truth = cast(scene, camera, 301, 301);
        for (std::uint32_t y = 0; y < truth.height; ++y) {
            for (std::uint32_t x = 0; x < truth.width; ++x) {
                const double tangent = std::tan(0.5 * camera.fovY);
                const glm::dvec3 ray = glm::normalize(glm::dvec3((2.0 * x + 1.0 - 301) / 301 * tangent,
                                                                 (300.0 - 2.0 * y) / 301 * tangent, -1.0));
                // The camera looks at the centre, so this is how far the ray passes it.
                const double offset = distance * std::hypot(ray.x, ray.y);
                if (offset < inner * 0.9999) {
                    ++inside;
                    ASSERT_EQ(truth.at(x, y).id, 1u) << distance << ": " << x << ' ' << y;
                } else if (offset > 1.0001) {
                    ASSERT_EQ(truth.at(x, y).id, 0u) << distance << ": " << x << ' ' << y;
                }
            }
        }
    }
    std::printf("%d pixels inside\n", inside);
    EXPECT_GT(inside, 100000);
}

TEST(Watertight, CubesEdgesAndCornersHit) {
    scene::Scene scene = makeEmptyScene();
    for (const std::uint32_t mesh : {kCube, kTriangleCube}) {
        scene.instances = {};
        // Two cubes that share a face edge-on: the middle column of rays runs exactly along it.
        addObject(scene, mesh, {-0.5, 0.0, -10.0});
        addObject(scene, mesh, {0.5, 0.0, -10.0});
        const measure::TruthImage truth = cast(scene, makePlainCamera(), 101, 101);
        for (std::uint32_t y = 48; y <= 52; ++y) {
            EXPECT_EQ(truth.at(50, y).id, 2u);
            EXPECT_EQ(truth.at(50, y).secondId, 1u);
        }
    }
}

} // namespace cdr::test
