#include "../fixture.h"

#include <cmath>
#include <set>
#include <string>

namespace cdr::render_test {

namespace {

using VerticesTest = RenderTest;

/// Another shape of a box at each step; every third has the facets of a box.
std::vector<scene::Vertex> shapeAt(int step) {
    std::vector<scene::Vertex> vertices = scene::makeBox(glm::vec3(0.5f)).vertices;
    for (scene::Vertex& vertex : vertices) {
        vertex.position.x *= 1.0f + 0.2f * static_cast<float>(step);
        vertex.position.y += 0.3f * std::sin(static_cast<float>(step) + 4.0f * vertex.position.x);
        if (step % 3 != 0) {
            vertex.normal = glm::normalize(vertex.position);
        }
    }
    return vertices;
}

scene::Scene deformedScene(const std::vector<scene::Vertex>& vertices) {
    scene::Scene scene = boxScene();
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].vertices = vertices;
    scene.meshes[1].boundingRadius = scene::boundingRadiusOf(vertices);
    scene.meshes[1].boxHalfSides.reset();
    for (std::uint32_t i = 0; i < 6; ++i) {
        scene::addInstance(scene, i % 2, 0, i, {2.0 * i - 5.0, 0.3 * i, -9.0 - 100.0 * i}, glm::mat3(1.5f));
    }
    return scene;
}

/// A frame that nobody waits for comes before each that is compared.
TEST_F(VerticesTest, GiveThePictureOfASceneBuiltAnew) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 1.0, .farView = 1000.0};
    for (const render::Submission submission : submissions()) {
        for (const std::size_t inFlight : {std::size_t{1}, std::size_t{3}}) {
            scene::World world(deformedScene(shapeAt(0)));
            render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
            options.submission = submission;
            options.framesInFlight = inFlight;
            options.threads = inFlight;
            SoleRenderer renderer(device(), world, options);
            for (int step = 1; step < 8; ++step) {
                world.setVertices(world.mesh(1), shapeAt(step + 100));
                renderer.submit(camera);
                world.setVertices(world.mesh(1), shapeAt(step));
                renderer.forgetFrames();
                const scene::Scene built = deformedScene(shapeAt(step));
                ASSERT_EQ(hashOf(renderer.render(camera)), hashOf(draw(built, camera, options)))
                    << "step " << step << ", submission " << nameOf(submission);
                ASSERT_EQ(world.scene().instances.radius, built.instances.radius);
            }
        }
    }
}

/// Tangents of a box that are others at each step.
std::vector<scene::VertexDetail> detailsAt(int step, std::size_t vertices) {
    const auto angle = static_cast<float>(step);
    return std::vector<scene::VertexDetail>(
        vertices, {.tangent = {std::cos(angle), std::sin(angle), 0.5f, step % 2 == 0 ? 1.0f : -1.0f}});
}

scene::Scene bumpyScene(int step) {
    scene::Scene scene = deformedScene(shapeAt(step));
    scene.meshes[1].details = detailsAt(step, scene.meshes[1].vertices.size());
    scene.textures.push_back(
        {.pixels = image::ImageRgba8(1, 1, {200, 90, 220, 255}), .content = scene::TextureContent::data});
    scene.materials[0].detail.normal = scene::TextureUse{};
    return scene;
}

TEST_F(VerticesTest, BringTheirTangents) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 1.0, .farView = 1000.0};
    const render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    scene::World world(bumpyScene(0));
    SoleRenderer renderer(device(), world, options);
    const scene::Scene still = bumpyScene(1);
    std::set<std::string> pictures;
    for (int step = 0; step < 4; ++step) {
        const std::vector<scene::Vertex>& vertices = still.meshes[1].vertices;
        world.setVertices(world.mesh(1), vertices, detailsAt(step, vertices.size()));
        scene::Scene built = still;
        built.meshes[1].details = detailsAt(step, vertices.size());
        const std::string picture = hashOf(renderer.render(camera));
        EXPECT_EQ(picture, hashOf(draw(built, camera, options))) << "step " << step;
        pictures.insert(picture);
    }
    EXPECT_EQ(pictures.size(), 4u);
}

/// Pipelines of snapped vertices are made anew for a size, and gpu-driven ones group the instances anew. AddressSanitizer would
/// see instances of the old scene looked up in the new one.
TEST_F(VerticesTest, ASizeMayChangeAfterTheWorldDid) {
    for (const render::Submission submission : submissions()) {
        scene::World world(deformedScene(shapeAt(0)));
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        options.snapBits = 8;
        SoleRenderer renderer(device(), world, options);
        renderer.render({});
        world = scene::World(boxScene());
        world.addInstance({.mesh = world.mesh(0),
                           .material = world.material(0),
                           .transform = {.position = {0.0, 0.0, -5.0}}});
        options.width += 16;
        renderer.resize(options.width, options.height);
        EXPECT_EQ(renderer.render({}).color.pixels, draw(world.scene(), {}, options).color.pixels)
            << nameOf(submission);
    }
}

} // namespace

} // namespace cdr::render_test
