#include "../../support/all_cases.h"
#include "../../support/deformers.h"
#include "../fixture.h"
#include "../steps.h"

#include <cdr/render/draw_source.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/visibility/mesh_chunks.h>
#include <scenes/terrain.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cdr::render_test {

namespace {

using render::RenderOptions;

constexpr std::uint32_t kCells = 96;

/// Hills four times: as they are, turned and mirrored above the camera, small beside it, and below, with a layer that lifts them above.
scene::SceneSetup hillsAround() {
    scene::SceneSetup setup = scenes::makeTerrain(2013, kCells);
    scene::Scene& scene = setup.scene;
    scene.materials.push_back({.name = "above", .doubleSided = true, .layer = 300.0f});
    const glm::dvec3 eye = setup.path.at(0).position;
    scene::addInstance(scene, 0, 0, 1, eye + glm::dvec3(0.0, 9e3, 0.0),
                       glm::mat3(-0.5f, 0, 0, 0, -0.5f, 0.1f, 0.2f, 0, -0.5f));
    scene::addInstance(scene, 0, 0, 2, eye + glm::dvec3(30.0, 5.0, 20.0), glm::mat3(1e-3f));
    scene::addInstance(scene, 0, 1, 3, eye + glm::dvec3(0.0, -100.0, 0.0), glm::mat3(0.2f));
    // A lamp that stands in what it lights, and the sun.
    scene.lights = {{.position = eye + glm::dvec3(100.0, 40.0, -50.0), .halfDistance = 500.0},
                    {.position = glm::dvec3(3e5, 2e5, 1e5), .halfDistance = 1e7}};
    return setup;
}

/// The same triangles in the same order. Among those of each chunk are two without an area, so that its box is that of the mesh and
/// no chunk is left out.
scene::Scene withWideChunks(scene::Scene scene) {
    for (scene::Mesh& mesh : scene.meshes) {
        const auto [lowest, highest] = std::minmax_element(
            mesh.vertices.begin(), mesh.vertices.end(),
            [](const scene::Vertex& a, const scene::Vertex& b) { return a.position.y < b.position.y; });
        const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
        const auto low = static_cast<std::uint32_t>(lowest - mesh.vertices.begin());
        const auto high = static_cast<std::uint32_t>(highest - mesh.vertices.begin());
        std::vector<std::uint32_t> indices;
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            if (i % (3 * (visibility::kChunkTriangles - 2)) == 0) {
                indices.insert(indices.end(), {0, 0, last, low, low, high});
            }
            indices.push_back(mesh.indices[i]);
        }
        mesh.indices = indices;
    }
    return scene;
}

class LargeMeshesTest : public RenderTest {
  protected:
    /// Whether parts that are left out would have been seen, or have cast a shadow that is.
    void expectAllSeen(const RenderOptions& options, std::uint32_t step, double farView = 0.0) {
        const scene::SceneSetup setup = hillsAround();
        const scene::Scene other = withWideChunks(setup.scene);
        const render::GpuScene ordered(device(), setup.scene);
        const render::GpuScene wide(device(), other);
        ASSERT_EQ(ordered.uploaded().kinds().at(0).mesh.chunkCount, 36u);
        render::Renderer cut(device(), setup.scene, ordered, options);
        render::Renderer whole(device(), other, wide, options);
        for (std::uint32_t frame = 0; frame < 360; frame += step) {
            scene::Camera camera = setup.path.at(frame);
            camera.farView = std::max(camera.farView, farView);
            camera.lensShift = frame % 2 == 0 ? glm::dvec2(0.0) : glm::dvec2(0.3, -0.1);
            ASSERT_EQ(hashOf(cut.render(camera)), hashOf(whole.render(camera)))
                << "frame " << frame << ", " << nameOf(options.technique);
        }
    }
};

TEST_F(LargeMeshesTest, AreSeenAsIfDrawnWhole) {
    for (const depth::Technique& technique : presetTechniques()) {
        RenderOptions options = quarterOf(smallOptions(technique));
        options.threads = 2;
        expectAllSeen(options, test::takesAllCases() ? 7 : 61);
    }
}

/// Then float32 rounds vertices by the distance to the far plane.
TEST_F(LargeMeshesTest, AreSeenWhereTheAnchorIsFarBehindThem) {
    RenderOptions options = quarterOf(smallOptions(depth::parseTechnique("anchored-reversed/none")));
    expectAllSeen(options, test::takesAllCases() ? 7 : 13, 3e10);
}

TEST_F(LargeMeshesTest, CastTheShadowsOfWholeOnes) {
    for (const render::ShadowMethod method : {render::ShadowMethod::anchored, render::ShadowMethod::plain}) {
        RenderOptions options = quarterOf(smallOptions(depth::parseTechnique("anchored")));
        options.shadows = {.method = method, .maxTexels = 512};
        expectAllSeen(options, test::takesAllCases() ? 7 : 61);
    }
}

/// A sheet that the lower edge of the picture cuts, and its morph target, of which more is seen.
std::shared_ptr<const scene::Deformer> makeSheet() {
    constexpr std::uint32_t kSide = 48;
    auto deformer = std::make_shared<scene::Deformer>();
    std::vector<scene::MorphDelta>& raised = deformer->targets.emplace_back();
    const auto at = [](std::uint32_t i) { return static_cast<float>(i) / kSide - 0.5f; };
    const auto add = [&](std::uint32_t x, std::uint32_t z) {
        raised.push_back({.vertex = static_cast<std::uint32_t>(deformer->vertices.size()),
                          .position = {0.0f, 6.0f * std::cos(5.0f * at(x)), 0.0f}});
        deformer->vertices.push_back(
            {.position = {10.0f * at(x), 0.0f, 10.0f * at(z)}, .normal = {0.0f, 1.0f, 0.0f}});
    };
    for (std::uint32_t z = 0; z < kSide; ++z) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            for (const auto& [right, down] :
                 {std::pair(0u, 0u), {0u, 1u}, {1u, 0u}, {1u, 0u}, {0u, 1u}, {1u, 1u}}) {
                add(x + right, z + down);
            }
        }
    }
    finish(*deformer);
    return deformer;
}

scene::Scene sheetScene(const std::vector<scene::Vertex>& vertices) {
    scene::Scene scene = boxScene();
    scene::Mesh& mesh = scene.meshes.emplace_back();
    mesh.vertices = vertices;
    mesh.indices.resize(vertices.size());
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    mesh.boundingRadius = scene::boundingRadiusOf(vertices);
    scene::addInstance(scene, 1, 0, 0, {0.0, -9.0, -15.0}, glm::mat3(1.0f));
    scene.lights.front().position = {0.0, 30.0, -10.0};
    return scene;
}

/// By the CPU, by the device, and by the CPU again.
TEST_F(LargeMeshesTest, AreSeenWhereTheirVerticesAreNow) {
    const auto sheet = makeSheet();
    const scene::Camera camera{.fovY = 1.0, .nearView = 1.0, .farView = 100.0};
    RenderOptions options = quarterOf(smallOptions(depth::parseTechnique("anchored")));
    options.shadows.method = render::ShadowMethod::anchored;
    const scene::MeshPose raised{
        .deformer = sheet, .weights = {1.0}, .joints = {}, .place = placeOf(*sheet, glm::dmat4(1.0))};
    const std::vector<scene::Vertex> vertices = test::deformedByCpu(raised).vertices;
    ASSERT_FALSE(visibility::chunksOf(vertices, sheetScene(vertices).meshes[1].indices).empty());
    const std::string wanted = hashOf(draw(sheetScene(vertices), camera, options));
    const std::string flat = hashOf(draw(sheetScene(sheet->vertices), camera, options));

    scene::World world(sheetScene(sheet->vertices));
    SoleRenderer renderer(device(), world, options);
    EXPECT_EQ(hashOf(renderer.render(camera)), flat);
    world.setVertices(world.mesh(1), vertices);
    EXPECT_EQ(hashOf(renderer.render(camera)), wanted);
    world.setVertices(world.mesh(1), sheet->vertices);
    EXPECT_EQ(hashOf(renderer.render(camera)), flat);
    if (device().info().deformMissing.empty()) {
        world.setPose(world.mesh(1), raised);
        const render::Frame expected = draw(sheetScene(vertices), camera, options);
        EXPECT_LE(largestStep(renderer.render(camera).color, expected.color), 1) << "of rounded normals";
    }
}

} // namespace

} // namespace cdr::render_test
