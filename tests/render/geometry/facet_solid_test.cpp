#include <cdr/render/geometry/facet_solid.h>
#include <cdr/scene/mesh.h>
#include <scenes/sheets.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace cdr::render {

namespace {

/// A square in the plane z = 0 that faces +z: two triangles.
scene::Mesh square() {
    return scenes::makeSquare(1.0f);
}

std::size_t facetsOf(const scene::Mesh& mesh) {
    const std::optional<FacetSolid> solid = FacetSolid::of(mesh, mesh.indices);
    return solid ? solid->facets().size() : 0;
}

TEST(FacetSolid, JoinsTrianglesOfOnePlane) {
    EXPECT_EQ(facetsOf(square()), 1u);
    const scene::Mesh box = scene::makeBox(glm::vec3(0.5f));
    EXPECT_EQ(facetsOf(box), 6u);
}

TEST(FacetSolid, RefusesTrianglesWhoseCornersDiffer) {
    scene::Mesh smooth = square();
    smooth.vertices[1].normal = glm::normalize(glm::vec3(0.1f, 0.0f, 1.0f));
    EXPECT_EQ(facetsOf(smooth), 0u);
    scene::Mesh colored = square();
    colored.vertices[1].color = glm::u8vec4(0);
    EXPECT_EQ(facetsOf(colored), 0u);
}

TEST(FacetSolid, RefusesNormalsThatAreNotTheTriangles) {
    scene::Mesh tilted = square();
    for (scene::Vertex& vertex : tilted.vertices) {
        vertex.normal = glm::normalize(glm::vec3(0.5f, 0.0f, 1.0f));
    }
    EXPECT_EQ(facetsOf(tilted), 0u);
    scene::Mesh turned = square();
    turned.indices = {0, 2, 1, 0, 3, 2};
    EXPECT_EQ(facetsOf(turned), 0u);
}

TEST(FacetSolid, RefusesWhatIsNotPlane) {
    scene::Mesh bent = square();
    bent.vertices[3].position.z = 1e-3f; // a normal that the cosine alone lets pass
    EXPECT_EQ(facetsOf(bent), 0u);
}

TEST(FacetSolid, RefusesTooManyParts) {
    scene::Mesh steps;
    for (std::size_t step = 0; step <= kMaxSolidParts; ++step) {
        const auto first = static_cast<std::uint32_t>(steps.vertices.size());
        for (scene::Vertex vertex : square().vertices) {
            vertex.position.z = static_cast<float>(step);
            steps.vertices.push_back(vertex);
        }
        for (const std::uint32_t corner : {0u, 1u, 2u}) {
            steps.indices.push_back(first + corner);
        }
    }
    steps.boundingRadius = 100.0f;
    EXPECT_EQ(facetsOf(steps), 0u);
    steps.indices.resize(3 * 20);
    EXPECT_EQ(facetsOf(steps), 20u);
}

TEST(FacetSolid, LeavesOutTrianglesWithoutAnArea) {
    scene::Mesh mesh = square();
    mesh.indices.insert(mesh.indices.end(), {1, 1, 2});
    EXPECT_EQ(facetsOf(mesh), 1u);
}

} // namespace

} // namespace cdr::render
