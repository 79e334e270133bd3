#include "../../support/deformers.h"
#include "../../support/refusal.h"
#include "../failed_edits.h"
#include "../fixture.h"
#include "../steps.h"

#include <cdr/gpu/commands.h>
#include <cdr/gpu/memory.h>
#include <cdr/render/materials/packed_vertex.h>
#include <cdr/render/uploaded_scene.h>

#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <numeric>
#include <set>

namespace cdr::render_test {

namespace {

/// Vertices that the device deforms, against those that the CPU does.
class DeviceVerticesTest : public DeformTest {
  protected:
    /// Those of all meshes, as they are once what was submitted is done.
    std::vector<render::PackedVertex> read(const render::GpuScene& scene, std::size_t count) {
        const std::size_t bytes = count * sizeof(render::PackedVertex);
        const gpu::Buffer copy(device(), bytes, vk::BufferUsageFlagBits::eTransferDst,
                               gpu::MemoryUse::hostReads, "vertices of a test");
        gpu::runOnce(device(), [&](vk::CommandBuffer commands) {
            commands.copyBuffer(scene.uploaded().vertices(), copy.handle(), vk::BufferCopy{.size = bytes});
        });
        copy.invalidate();
        const auto vertices = copy.as<render::PackedVertex>(count);
        return {vertices.begin(), vertices.end()};
    }
};

scene::Mesh meshOf(const scene::Deformer& deformer) {
    scene::Mesh mesh;
    mesh.vertices = deformer.vertices;
    mesh.details = deformer.details;
    mesh.indices.resize(mesh.vertices.size());
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    mesh.boundingRadius = scene::boundingRadiusOf(mesh.vertices);
    return mesh;
}

/// A box, and a deformed mesh behind it in the buffers, whose material has a normal texture.
scene::Scene sceneOf(const scene::Deformer& deformer) {
    scene::Scene scene = boxScene();
    scene.meshes.push_back(meshOf(deformer));
    scene.textures.push_back(
        {.pixels = image::ImageRgba8(1, 1, {200, 90, 220, 255}), .content = scene::TextureContent::data});
    scene.materials[0].detail.normal = scene::TextureUse{};
    addBox(scene, {1.0, 0.5, -7.0});
    scene::addInstance(scene, 1, 0, 7, {0.0, 0.0, -12.0}, glm::mat3(1.0f));
    return scene;
}

int stepsApart(std::uint32_t a, std::uint32_t b) {
    const auto half = [](std::uint32_t word, unsigned shift) {
        return static_cast<std::int16_t>(word >> shift);
    };
    return std::max(std::abs(half(a, 0u) - half(b, 0u)), std::abs(half(a, 16u) - half(b, 16u)));
}

/// The same picture but for normals, of which Vulkan lets a step of 16 bits differ at a vertex.
void expectAlike(const render::Frame& frame, const render::Frame& wanted, const std::string& what) {
    ASSERT_EQ(frame.gbuffer.pixels.size(), wanted.gbuffer.pixels.size());
    std::size_t others = 0;
    int most = 0;
    for (std::size_t i = 0; i < frame.gbuffer.pixels.size(); ++i) {
        const auto& [albedo, normal, ahead, id] = frame.gbuffer.pixels[i];
        const auto& [wantedAlbedo, wantedNormal, wantedAhead, wantedId] = wanted.gbuffer.pixels[i];
        others += albedo != wantedAlbedo || ahead != wantedAhead || id != wantedId;
        most = std::max(most, stepsApart(normal, wantedNormal));
    }
    EXPECT_EQ(others, 0u) << what;
    EXPECT_LE(most, 2) << what << ": a step of a vertex, and one of rounding";
    EXPECT_LE(largestStep(frame.color, wanted.color), 1) << what;
}

/// Positions to the bit, normals to a step of 16 bits, for each kind of deformer.
TEST_F(DeviceVerticesTest, AreThoseOfTheCpu) {
    for (const test::DeformerKind& kind : test::deformerKinds()) {
        const auto deformer = test::makeDeformer(kind, 1);
        scene::World world(sceneOf(*deformer));
        const std::size_t before = world.scene().meshes[0].vertices.size();
        const std::size_t count = deformer->vertices.size();
        render::GpuScene onDevice(device(), world);
        for (std::uint32_t seed = 0; seed < 4; ++seed) {
            const scene::MeshPose pose = test::poseOf(kind, deformer, seed);
            const scene::MeshVertices expected = test::deformedByCpu(pose);
            world.setPose(world.mesh(1), pose);
            EXPECT_FALSE(onDevice.uploaded().hasHostVertices());
            onDevice.update();
            const std::vector<render::PackedVertex> made = read(onDevice, before + count);
            std::size_t wrong = 0;
            int most = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const render::PackedVertex& vertex = made[before + i];
                const render::PackedVertex right = render::packed(expected.vertices[i]);
                const bool isSame =
                    vertex.position == right.position && vertex.uv == right.uv && vertex.color == right.color;
                wrong += isSame ? 0 : 1;
                most = std::max(most, stepsApart(vertex.normal, right.normal));
            }
            EXPECT_EQ(wrong, 0u) << kind.name << ", pose " << seed;
            EXPECT_LE(most, 1) << kind.name << ", pose " << seed;
            EXPECT_EQ(made[0].position, world.scene().meshes[0].vertices[0].position);
        }
    }
}

/// Nobody waits between poses, frames that show them and frames that are read. Tangents show in the normal texture.
TEST_F(DeviceVerticesTest, GiveThePicturesOfTheCpu) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.5, .farView = 1000.0};
    for (const test::DeformerKind& kind : test::deformerKinds()) {
        const auto deformer = test::makeDeformer(kind, 2);
        for (const render::Submission submission : submissions()) {
            scene::World posed(sceneOf(*deformer));
            scene::World uploaded(sceneOf(*deformer));
            render::RenderOptions options = quarterOf(smallOptions(depth::parseTechnique("anchored")));
            options.submission = submission;
            options.framesInFlight = 3;
            SoleRenderer byDevice(device(), posed, options);
            SoleRenderer byCpu(device(), uploaded, options);
            std::set<std::string> pictures;
            for (std::uint32_t seed = 0; seed < 4; ++seed) {
                for (std::uint32_t hurried = 10; hurried < 14; ++hurried) {
                    posed.setPose(posed.mesh(1), test::poseOf(kind, deformer, seed + hurried));
                    byDevice.submit(camera);
                }
                const scene::MeshPose pose = test::poseOf(kind, deformer, seed);
                posed.setPose(posed.mesh(1), pose);
                uploaded.setVertices(uploaded.mesh(1), test::deformedByCpu(pose),
                                     scene::boundingRadiusOf(pose));
                byDevice.forgetFrames();
                byCpu.forgetFrames();
                const render::Frame picture = byDevice.render(camera);
                expectAlike(picture, byCpu.render(camera),
                            fmt::format("{}, pose {}, submission {}", kind.name, seed, nameOf(submission)));
                EXPECT_EQ(posed.scene().instances.radius, uploaded.scene().instances.radius);
                pictures.insert(hashOf(picture));
            }
            EXPECT_EQ(pictures.size(), 4u) << kind.name;
        }
    }
}

/// Where the meshes move in the buffers, or the scene is uploaded again, the device deforms again.
TEST_F(DeviceVerticesTest, OutlastEditsOfOtherMeshes) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.5, .farView = 1000.0};
    const test::DeformerKind kind = test::deformerKinds()[2];
    const auto deformer = test::makeDeformer(kind, 3);
    const scene::MeshPose pose = test::poseOf(kind, deformer, 5);
    scene::World posed(sceneOf(*deformer));
    scene::World uploaded(sceneOf(*deformer));
    const render::RenderOptions options = quarterOf(smallOptions(depth::parseTechnique("anchored")));
    SoleRenderer byDevice(device(), posed, options);
    SoleRenderer byCpu(device(), uploaded, options);
    posed.setPose(posed.mesh(1), pose);
    uploaded.setVertices(uploaded.mesh(1), test::deformedByCpu(pose), scene::boundingRadiusOf(pose));
    expectAlike(byDevice.render(camera), byCpu.render(camera), "at first");
    for (int step = 0; step < 3; ++step) {
        for (scene::World* world : {&posed, &uploaded}) {
            const scene::MeshHandle mesh =
                world->addMesh(scene::makeBox(glm::vec3(0.3f + 0.1f * static_cast<float>(step))));
            world->addInstance({.mesh = mesh,
                                .material = world->material(0),
                                .object = 20,
                                .transform = {.position = {-2.0 + step, 1.0, -6.0}}});
        }
        expectAlike(byDevice.render(camera), byCpu.render(camera), fmt::format("step {}", step));
    }
    expectAlike(SoleRenderer(device(), posed, options).render(camera), byCpu.render(camera),
                "uploaded again");
}

/// A pose of one joint, which scales and turns.
scene::MeshPose jointPose(const scene::Mesh& mesh, const glm::dmat4& joint) {
    auto deformer = std::make_shared<scene::Deformer>();
    deformer->vertices = mesh.vertices;
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        deformer->firstInfluence.push_back(i);
        deformer->influences.push_back({0, 1.0f});
    }
    deformer->firstInfluence.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
    finish(*deformer);
    scene::MeshPose pose{.deformer = deformer, .weights = {}, .joints = {joint}, .place = {}};
    pose.place = placeOf(*deformer, pose.joints);
    return pose;
}

/// The bounds of a pose need not hold the vertices at rest.
TEST_F(DeviceVerticesTest, OfAPosedWorldAreThereInAnotherGpuScene) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -7.0});
    const scene::MeshPose pose = jointPose(scene.meshes[0], glm::scale(glm::dmat4(1.0), glm::dvec3(0.5)));
    scene::World world(std::move(scene));
    const render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    SoleRenderer live(device(), world, options);
    world.setPose(world.mesh(0), pose);
    const std::string wanted = hashOf(live.render({}));
    EXPECT_EQ(hashOf(SoleRenderer(device(), world, options).render({})), wanted);
    const scene::World copy = world;
    EXPECT_EQ(hashOf(SoleRenderer(device(), copy, options).render({})), wanted);
}

/// Whether a mesh has facets is asked of its own triangles, not of those at its place before.
TEST_F(DeviceVerticesTest, OfAMeshInThePlaceOfAnotherAreShadedByItsOwnTriangles) {
    const scene::Mesh box = scene::makeBox(glm::vec3(1.0f));
    scene::Mesh joined = box; // triangles that join corners of different faces
    joined.boxHalfSides.reset();
    joined.indices.clear();
    for (std::uint32_t i = 0; i < 24; ++i) {
        joined.indices.insert(joined.indices.end(), {i, (i + 5) % 24, (i + 10) % 24});
    }
    const scene::MeshPose pose = jointPose(box, glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(1.0, 1.0, 0.0)));
    const render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    const auto add = [](scene::World& world, const scene::Mesh& mesh) {
        const scene::MeshHandle handle = world.addMesh(mesh);
        const scene::InstanceHandle instance = world.addInstance(
            {.mesh = handle, .material = world.material(0), .object = 3, .transform = {{0.0, 0.0, -5.0}}});
        return std::pair(handle, instance);
    };
    scene::World world(boxScene());
    SoleRenderer live(device(), world, options);
    const auto [before, instance] = add(world, box);
    world.setPose(before, pose);
    live.render({});
    world.removeInstance(instance);
    world.removeMesh(before);
    const auto [after, other] = add(world, joined);
    ASSERT_EQ(after.index, before.index);
    world.setPose(after, pose);
    scene::World anew(boxScene());
    anew.setPose(add(anew, joined).first, pose);
    EXPECT_EQ(hashOf(live.render({})), hashOf(SoleRenderer(device(), anew, options).render({})));
}

/// A texture ends the update once the device has deformed the new mesh. The next update uploads that mesh again.
TEST_F(DeviceVerticesTest, OfANewMeshAreThoseOfItsPoseWhereTheUpdateIsRepeated) {
    const scene::Mesh box = scene::makeBox(glm::vec3(1.0f));
    const scene::MeshPose pose = jointPose(box, glm::scale(glm::dmat4(1.0), glm::dvec3(0.5)));
    const render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    scene::World world(boxScene());
    SoleRenderer live(device(), world, options);
    world.addMesh(box);
    live.draw({}); // now there is room for two meshes more
    const scene::MeshHandle mesh = world.addMesh(box);
    world.addInstance({.mesh = mesh, .material = world.material(0), .transform = {{0.0, 0.0, -5.0}}});
    world.setPose(mesh, pose);
    const image::ImageRgba8 wide(device().info().maxImageSide + 1, 1, {255, 255, 255, 255});
    const scene::TextureHandle texture = world.addTexture({.name = {}, .pixels = wide});
    const scene::MaterialHandle material = world.addMaterial({.baseColorTexture = texture.index});
    EXPECT_THROW(live.draw({}), base::InputError);
    world.removeMaterial(material);
    world.removeTexture(texture);
    EXPECT_EQ(hashOf(live.render({})), hashOf(SoleRenderer(device(), world, options).render({})));
}

/// Tangents that come with the first normal texture are those of the pose, also where the device could not be told to deform them
/// in the frame that uploads them.
TEST_F(DeviceVerticesTest, HaveTangentsAfterAFailedFrame) {
    const test::DeformerKind kind = test::deformerKinds()[0];
    const auto deformer = test::makeDeformer(kind, 4);
    scene::World begun(sceneOf(*deformer));
    const scene::Material bumpy = begun.scene().materials[0];
    scene::Material plain = bumpy;
    plain.detail.normal.reset();
    begun.setMaterial(begun.material(0), plain);
    begun.setPose(begun.mesh(1), test::poseOf(kind, deformer, 6));
    const auto edit = [&](scene::World& world) { world.setMaterial(world.material(0), bumpy); };
    EXPECT_GE(expectEditOutlivesFailures(device(), "vkCreateBuffer", begun, edit), 2u);
    EXPECT_GE(expectEditOutlivesFailures(device(), "vkQueueSubmit2", begun, edit), 3u); // upload, pose, frame
}

/// A box whose pose is no longer faceted.
TEST_F(DeviceVerticesTest, TakeTheirPipelineAfterAFailedFrame) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0});
    scene::Mesh round = scene.meshes[0];
    for (scene::Vertex& vertex : round.vertices) {
        vertex.normal = glm::normalize(vertex.position);
    }
    const scene::MeshPose pose =
        jointPose(round, glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(1.0, 1.0, 0.0)));
    const scene::World begun(std::move(scene));
    const auto edit = [&](scene::World& world) { world.setPose(world.mesh(0), pose); };
    EXPECT_GE(expectEditOutlivesFailures(device(), "vkCreateBuffer", begun, edit), 4u);
    EXPECT_GE(expectEditOutlivesFailures(device(), "vkQueueSubmit2", begun, edit), 3u); // upload, pose, frame
}

/// Neither its shared pointer nor its buffer.
TEST_F(DeviceVerticesTest, KeepNoDeformerOfAMeshThatHasNoPose) {
    const scene::Mesh box = scene::makeBox(glm::vec3(1.0f));
    using Edit = void (*)(scene::World&, scene::MeshHandle, const scene::Mesh&);
    const Edit goes = [](scene::World& world, scene::MeshHandle mesh, const scene::Mesh&) {
        world.removeMesh(mesh);
    };
    const Edit isGivenVertices = [](scene::World& world, scene::MeshHandle mesh, const scene::Mesh& made) {
        world.setVertices(mesh, made.vertices);
    };
    const Edit isOfAnotherWorld = [](scene::World& world, scene::MeshHandle, const scene::Mesh&) {
        world = scene::World(boxScene());
    };
    for (const Edit edit : {goes, isGivenVertices, isOfAnotherWorld}) {
        scene::World world(boxScene());
        const scene::MeshHandle mesh = world.addMesh(box);
        scene::MeshPose pose = jointPose(box, glm::scale(glm::dmat4(1.0), glm::dvec3(0.5)));
        const std::weak_ptr<const scene::Deformer> deformer = pose.deformer;
        world.setPose(mesh, std::move(pose));
        render::GpuScene onDevice(device(), world);
        edit(world, mesh, box);
        onDevice.update();
        gpu::waitForQueue(device());
        onDevice.update(); // frees what the queue is done with
        EXPECT_TRUE(deformer.expired());
    }
}

/// Facets are made by the CPU, which needs the vertices for them.
TEST_F(DeviceVerticesTest, AreNoFacetsUnlessTheCpuHasThemToo) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.5, .farView = 1000.0};
    scene::Scene scene = boxScene();
    auto deformer = std::make_shared<scene::Deformer>();
    deformer->vertices = scene.meshes[0].vertices;
    finish(*deformer);
    const scene::MeshPose pose{.deformer = deformer, .weights = {}, .joints = {}, .place = {}};
    addBox(scene, {0.0, 0.0, -7.0});
    scene::World world(std::move(scene));
    render::GpuScene onDevice(device(), world);
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    options.surface = render::SurfacePath::visibility;
    render::Renderer renderer(device(), onDevice, options);
    renderer.render(camera);
    world.setPose(world.mesh(0), pose);
    const std::string message = test::inputErrorOf([&] { renderer.render(camera); });
    EXPECT_NE(message.find("vertices of meshes that the device deforms"), std::string::npos) << message;
    world.setPose(world.mesh(0), pose, test::deformedByCpu(pose));
    EXPECT_TRUE(onDevice.uploaded().hasHostVertices());
    renderer.render(camera);
}

} // namespace

} // namespace cdr::render_test
