#include <cdr/render/geometry/facet_vertices.h>

#include <gtest/gtest.h>

#include <array>
#include <span>

namespace cdr::render {

namespace {

using Corners = std::array<glm::vec3, 3>;

Corners cornersOf(const scene::Mesh& mesh, const std::uint32_t* triangle) {
    return {mesh.vertices[triangle[0]].position, mesh.vertices[triangle[1]].position,
            mesh.vertices[triangle[2]].position};
}

bool isTurned(const Corners& a, const Corners& b) {
    return a == b || a == Corners{b[1], b[2], b[0]} || a == Corners{b[2], b[0], b[1]};
}

void expectSameFacets(const scene::Mesh& before, std::span<const std::uint32_t> beforeIndices,
                      const scene::Mesh& after, std::span<const std::uint32_t> afterIndices) {
    ASSERT_EQ(beforeIndices.size(), afterIndices.size());
    for (std::size_t i = 0; i < beforeIndices.size(); i += 3) {
        ASSERT_TRUE(isTurned(cornersOf(before, &beforeIndices[i]), cornersOf(after, &afterIndices[i]))) << i;
        const scene::Vertex& wanted = before.vertices[beforeIndices[i]];
        const scene::Vertex& first = after.vertices[afterIndices[i]];
        ASSERT_EQ(wanted.normal, first.normal) << i;
        ASSERT_EQ(wanted.color, first.color) << i;
    }
}

TEST(FacetVertices, ABoxNeedsItsEightCorners) {
    const scene::Mesh box = scene::makeBox(glm::vec3(0.5f, 1.0f, 2.0f));
    const scene::Mesh shared = shareFacetVertices(box);
    EXPECT_EQ(shared.vertices.size(), 8u);
    expectSameFacets(box, box.indices, shared, shared.indices);
}

TEST(FacetVertices, ColoursOfTrianglesStayApart) {
    scene::Mesh box = scene::unshareVertices(scene::makeBox(glm::vec3(1.0f)));
    for (std::size_t i = 0; i < box.vertices.size(); ++i) {
        box.vertices[i].color = glm::u8vec4(static_cast<std::uint8_t>(i / 3));
    }
    const scene::Mesh shared = shareFacetVertices(box);
    EXPECT_GE(shared.vertices.size(), 12u); // a triangle each
    EXPECT_LT(shared.vertices.size(), 24u);
    expectSameFacets(box, box.indices, shared, shared.indices);
}

TEST(FacetVertices, LevelsAreSharedToo) {
    scene::Mesh box = scene::makeBox(glm::vec3(1.0f));
    box.levels.push_back({.indices = {box.indices.begin(), box.indices.begin() + 18}, .error = 1.0f});
    const scene::Mesh shared = shareFacetVertices(box);
    ASSERT_EQ(shared.levels.size(), 1u);
    EXPECT_EQ(shared.levels[0].error, 1.0f);
    expectSameFacets(box, box.levels[0].indices, shared, shared.levels[0].indices);
}

} // namespace

} // namespace cdr::render
