#include "../test_scenes.h"

#include <cdr/measure/truth/triangle_bvh.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cdr::test {

namespace {

using measure::kNoHit;
using measure::ObjectRay;
using measure::Sidedness;
using measure::ViewRange;

scene::Mesh makeSoup(std::mt19937_64& random, std::uint32_t triangles, float side) {
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    const auto point = [&] {
        const float x = place(random);
        const float y = place(random);
        return glm::vec3(x, y, place(random));
    };
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const glm::vec3 centre = point();
        for (std::uint32_t k = 0; k < 3; ++k) {
            mesh.indices.push_back(3 * i + k);
            mesh.vertices.push_back({.position = centre + side * point()});
        }
    }
    return mesh;
}

double nearestByAll(const scene::Mesh& mesh, const ObjectRay& ray, Sidedness sides, const ViewRange& range) {
    const measure::ShearedRay sheared(ray);
    double best = kNoHit;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]].position; };
        const double hit = sheared.meet({corner(0), corner(1), corner(2)}, sides);
        if (hit < best && range.holds(hit)) {
            best = hit;
        }
    }
    return best;
}

void expectAsAll(const scene::Mesh& mesh, std::mt19937_64& random, int rays) {
    const measure::TriangleBvh bvh(mesh);
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        const double x = place(random);
        const double y = place(random);
        const glm::dvec3 origin(x, y, place(random));
        glm::dvec3 direction(randomRotation(random)[0]);
        if (i % 8 == 0) {
            direction = {0.0, i % 16 ? 1.0 : -1.0, 0.0};
        }
        const Sidedness sides = i % 2 == 0 ? Sidedness::both : Sidedness::fronts;
        const ViewRange range{0.25, i % 3 ? 1.5 : 1e6};
        const double expected = nearestByAll(mesh, {origin, direction}, sides, range);
        const double hit = bvh.nearest({origin, direction}, sides, range);
        hits += hit < kNoHit;
        if (expected == kNoHit) {
            EXPECT_EQ(hit, kNoHit) << i;
        } else {
            EXPECT_NEAR(hit, expected, 1e-12) << i;
        }
    }
    EXPECT_GT(hits, 0);
}

} // namespace

TEST(TriangleBvh, FindsWhatTestingEveryTriangleFinds) {
    std::mt19937_64 random(1);
    for (const std::uint32_t triangles : {1u, 2u, 5u, 300u, 3000u}) {
        expectAsAll(makeSoup(random, triangles, triangles < 10 ? 2.0f : 0.3f), random, 2000);
    }
}

TEST(TriangleBvh, CopesWithCentresThatCoincide) {
    std::mt19937_64 random(2);
    scene::Mesh mesh = makeSoup(random, 1, 1.0f);
    const std::vector<scene::Vertex> corners = mesh.vertices;
    for (std::uint32_t i = 1; i < 500; ++i) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            mesh.indices.push_back(3 * i + k);
            mesh.vertices.push_back(corners[k]);
        }
    }
    expectAsAll(mesh, random, 400);
}

TEST(TriangleBvh, CopesWithSizesThatDifferByOrders) {
    std::mt19937_64 random(3);
    scene::Mesh mesh = makeSoup(random, 2000, 0.5f);
    // Centres in geometric progression make splits as uneven as they get.
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        mesh.vertices[i].position *= std::pow(0.97f, static_cast<float>(i / 3));
    }
    expectAsAll(mesh, random, 400);
}

TEST(TriangleBvh, WithoutTrianglesNothingIsHit) {
    const measure::TriangleBvh bvh{scene::Mesh{}};
    EXPECT_EQ(bvh.nearest({glm::dvec3(0, 0, 5), glm::dvec3(0, 0, -1)}, Sidedness::both, {0.1, 100.0}),
              kNoHit);
}

} // namespace cdr::test
