#include <cdr/visibility/chunk_test.h>
#include <cdr/visibility/mesh_chunks.h>
#include <scenes/terrain.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cdr::visibility_test {

namespace {

using visibility::ChunkTest;
using visibility::MeshChunk;

std::vector<MeshChunk> chunksOf(const scene::Mesh& mesh) {
    return visibility::chunksOf(mesh.vertices, mesh.indices);
}

scene::Mesh hills(std::uint32_t cells) {
    return scenes::makeTerrain(7, cells).scene.meshes[0];
}

bool holds(const MeshChunk& chunk, const glm::vec3& position) {
    return glm::all(glm::lessThanEqual(glm::abs(glm::dvec3(position) - glm::dvec3(chunk.middle)),
                                       glm::dvec3(chunk.half)));
}

TEST(MeshChunks, HoldTheirTriangles) {
    scene::Mesh mesh = hills(70);
    mesh.indices.resize(mesh.indices.size() - 3 * 123); // the last chunk is smaller
    const std::vector<MeshChunk> chunks = chunksOf(mesh);
    ASSERT_EQ(chunks.size(), (mesh.indices.size() / 3 + 511) / 512);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        ASSERT_TRUE(holds(chunks[i / 3 / 512], mesh.vertices[mesh.indices[i]].position)) << i;
    }
    EXPECT_LT(chunks[3].half.z, 0.1f * mesh.boundingRadius) << "a few rows";
}

TEST(MeshChunks, OnlyLargeMeshesHaveThem) {
    scene::Mesh mesh = hills(46); // of 4,232 triangles
    EXPECT_EQ(chunksOf(mesh).size(), 9u);
    mesh.indices.resize(std::size_t{3} * 4095);
    EXPECT_TRUE(chunksOf(mesh).empty());
    EXPECT_TRUE(chunksOf({}).empty());
}

TEST(MeshChunks, HoldTheLargestFloats) {
    constexpr float kMost = std::numeric_limits<float>::max();
    scene::Mesh mesh = hills(46);
    mesh.vertices[0].position = glm::vec3(kMost, -kMost, 1.0f);
    mesh.vertices[1].position = glm::vec3(-kMost, kMost, 1.0f);
    const MeshChunk chunk = chunksOf(mesh)[0];
    EXPECT_TRUE(holds(chunk, mesh.vertices[0].position));
    EXPECT_TRUE(holds(chunk, mesh.vertices[1].position));
}

/// The runs of chunks that a row of letters shows.
std::vector<std::pair<std::uint32_t, std::uint32_t>> runsOf(const std::string& shown, std::uint32_t indices) {
    const std::vector<MeshChunk> chunks(shown.size());
    std::size_t next = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
    visibility::forEachSeenRun(
        chunks, indices, [&](const MeshChunk&) { return shown[next++] == 'x'; },
        [&](const visibility::IndexRun& run) { runs.emplace_back(run.first, run.count); });
    return runs;
}

TEST(MeshChunks, NeighboursAreOneRun) {
    constexpr std::uint32_t kIndices = 4 * 1536 + 30; // of five chunks
    using Runs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    EXPECT_EQ(runsOf("xxxxx", kIndices), (Runs{{0, kIndices}}));
    EXPECT_EQ(runsOf("-----", kIndices), Runs{});
    EXPECT_EQ(runsOf("x-xx-", kIndices), (Runs{{0, 1536}, {2 * 1536, 2 * 1536}}));
    EXPECT_EQ(runsOf("-x--x", kIndices), (Runs{{1536, 1536}, {4 * 1536, 30}}));
}

/// Cameras, instances and cascades anywhere.
class ChunkTestCase {
  public:
    explicit ChunkTestCase(std::uint32_t seed) : m_engine(seed) {
        m_camera = {.fovY = 0.1 + 2.0 * unit(),
                    .nearView = 0.5,
                    .farView = 1e6,
                    .lensShift = seed % 3 == 0 ? glm::dvec2(unit(), -unit()) : glm::dvec2(0.0)};
        m_camera = scene::lookAlong(m_camera, vector(1e6), vector(1.0), glm::dvec3(0.1, 1.0, 0.2));
        m_frustum = scene::frustumOf(m_camera, 640, 360);
        const double nearView = std::exp2(12.0 * unit());
        m_range = {.nearView = nearView, .farView = nearView * (1.1 + 10.0 * unit())};
        const double size = 0.2 * std::exp2(-10.0 * unit());
        m_basis = glm::mat3(vector(size), vector(size), vector(size)); // mirrored and sheared, some
        m_position = m_camera.position + vector(6e3);
    }

    ChunkTest test() const { return {m_camera, m_frustum, m_range, 0.0}; }
    ChunkTest::Placed placed(const scene::Mesh& mesh) const {
        double most = 0.0;
        for (const scene::Vertex& vertex : mesh.vertices) {
            most = std::max(most, glm::length(glm::dmat3(m_basis) * glm::dvec3(vertex.position)));
        }
        return test().placed(m_position, m_basis, static_cast<float>(most * 1.0001));
    }
    /// Whether the cascade shows a place of the mesh, by a projection of its own.
    bool shows(const glm::dvec3& place) const {
        const glm::dvec3 from = m_position + glm::dmat3(m_basis) * place - m_camera.position;
        const double ahead = -glm::dot(from, m_camera.back);
        const glm::dvec2 onPicture(glm::dot(from, m_camera.right) / ahead,
                                   glm::dot(from, m_camera.up) / ahead);
        const glm::dvec2 fromMiddle = glm::abs(onPicture - m_camera.lensShift);
        return ahead >= m_range.nearView && ahead <= m_range.farView && fromMiddle.x <= m_frustum.tanX &&
               fromMiddle.y <= m_frustum.tanY;
    }
    double unit() { return static_cast<double>(m_engine()) / 4294967296.0; }

  private:
    glm::dvec3 vector(double size) {
        const double x = unit() - 0.5;
        const double y = unit() - 0.5;
        return 2.0 * size * glm::dvec3(x, y, unit() - 0.5);
    }

    std::mt19937 m_engine;
    scene::Camera m_camera;
    scene::Frustum m_frustum;
    depth::Cascade m_range;
    glm::mat3 m_basis{1.0f};
    glm::dvec3 m_position{0.0};
};

TEST(ChunkTests, LeaveOutOnlyWhatACascadeDoesNotShow) {
    const scene::Mesh mesh = hills(64);
    const std::vector<MeshChunk> chunks = chunksOf(mesh);
    std::size_t shown = 0;
    std::size_t leftOut = 0;
    std::size_t whole = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        ChunkTestCase some(seed);
        const ChunkTest test = some.test();
        const ChunkTest::Placed placed = some.placed(mesh);
        const bool holdsAll = test.holdsAll(placed);
        whole += holdsAll ? 1 : 0;
        for (std::size_t i = 0; i < chunks.size(); ++i) {
            leftOut += test.mayShow(placed, chunks[i]) ? 0 : 1;
        }
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const auto at = [&](std::size_t corner) {
                return glm::dvec3(mesh.vertices[mesh.indices[i + corner]].position);
            };
            const double u = some.unit();
            const double v = some.unit() * (1.0 - u);
            const bool isShown = some.shows(at(0) + u * (at(1) - at(0)) + v * (at(2) - at(0)));
            shown += isShown ? 1 : 0;
            ASSERT_TRUE(!isShown || test.mayShow(placed, chunks[i / 3 / 512]))
                << "seed " << seed << ", " << i;
            ASSERT_TRUE(!holdsAll || isShown) << "seed " << seed << ", " << i;
        }
    }
    EXPECT_GT(shown, 1000u);
    EXPECT_GT(leftOut, 1000u);
    EXPECT_GT(whole, 0u);
}

} // namespace

} // namespace cdr::visibility_test
