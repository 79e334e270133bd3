#include <cdr/render/upload/closed_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace cdr::render_test {

namespace {

bool isClosed(const scene::Mesh& mesh) {
    return render::isClosed(mesh.vertices, mesh.indices);
}

TEST(ClosedMesh, ABoxIsThoughEachFaceHasVerticesOfItsOwn) {
    EXPECT_TRUE(isClosed(scene::makeBox(glm::vec3(1.0f, 2.0f, 1e-3f))));
    EXPECT_TRUE(isClosed({})) << "nothing has no edges";
}

TEST(ClosedMesh, WithoutOneTriangleItIsOpen) {
    const scene::Mesh box = scene::makeBox(glm::vec3(1.0f));
    for (std::size_t triangle = 0; triangle < box.indices.size() / 3; ++triangle) {
        scene::Mesh open = box;
        const auto first = open.indices.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
        open.indices.erase(first, first + 3);
        EXPECT_FALSE(isClosed(open)) << triangle;
    }
}

scene::Mesh insideOut(scene::Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i], mesh.indices[i + 1]);
    }
    return mesh;
}

/// As one mesh, the second moved to the side.
scene::Mesh together(scene::Mesh mesh, const scene::Mesh& other, float aside) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (scene::Vertex vertex : other.vertices) {
        vertex.position.x += aside;
        mesh.vertices.push_back(vertex);
    }
    for (const std::uint32_t index : other.indices) {
        mesh.indices.push_back(first + index);
    }
    return mesh;
}

TEST(ClosedMesh, ATriangleThatLooksInwardsOpensIt) {
    scene::Mesh mesh = scene::makeBox(glm::vec3(1.0f));
    std::swap(mesh.indices[0], mesh.indices[1]);
    EXPECT_FALSE(isClosed(mesh));
}

/// A room that is modelled from within hides from the light what is in it, by faces that look away from the light.
TEST(ClosedMesh, NoPartMayBeInsideOut) {
    const scene::Mesh large = scene::makeBox(glm::vec3(2.0f));
    const scene::Mesh small = scene::makeBox(glm::vec3(1.0f));
    EXPECT_FALSE(isClosed(insideOut(large)));
    EXPECT_TRUE(isClosed(together(large, small, 10.0f)));
    EXPECT_FALSE(isClosed(together(large, insideOut(small), 10.0f)));
    EXPECT_FALSE(isClosed(together(insideOut(small), large, 10.0f)));
    EXPECT_TRUE(isClosed(together(large, small, 3.0f))) << "side by side, with the edges of neither";
}

TEST(ClosedMesh, AGapOfOneRoundingOpensIt) {
    scene::Mesh mesh = scene::makeBox(glm::vec3(1.0f));
    mesh.vertices[0].position.x = std::nextafter(mesh.vertices[0].position.x, 2.0f);
    EXPECT_FALSE(isClosed(mesh));
}

TEST(ClosedMesh, NegativeZeroIsZero) {
    const auto at = [](float x, float y, float z) { return scene::Vertex{.position = {x, y, z}}; };
    const std::vector<scene::Vertex> vertices{at(0.0f, 0.0f, 0.0f), at(1.0f, 0.0f, 0.0f),
                                              at(0.0f, 1.0f, 0.0f), at(0.0f, 0.0f, 1.0f),
                                              at(-0.0f, -0.0f, 0.0f)};
    const std::vector<std::uint32_t> indices{0, 2, 1, 4, 1, 3, 4, 3, 2, 1, 2, 3};
    EXPECT_TRUE(render::isClosed(vertices, indices));
}

TEST(ClosedMesh, OfTooManyTrianglesCountsAsOpen) {
    const scene::Mesh box = scene::makeBox(glm::vec3(1.0f));
    scene::Mesh many = box;
    while (many.indices.size() + box.indices.size() <= 3 * render::kMostClosedTriangles) {
        many.indices.insert(many.indices.end(), box.indices.begin(), box.indices.end());
    }
    EXPECT_TRUE(isClosed(many));
    many.indices.insert(many.indices.end(), box.indices.begin(), box.indices.end());
    EXPECT_FALSE(isClosed(many));
}

TEST(ClosedMesh, TrianglesWithoutAreaHaveNoEdges) {
    scene::Mesh mesh = scene::makeBox(glm::vec3(1.0f));
    mesh.indices.insert(mesh.indices.end(), {0, 0, 0, 1, 2, 1});
    EXPECT_TRUE(isClosed(mesh));
}

} // namespace

} // namespace cdr::render_test
