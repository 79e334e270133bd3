#include "../fixture.h"

#include <cdr/render/uploaded_scene.h>
#include <cdr/scene/world/world.h>

namespace cdr::render_test {

namespace {

class DrawKindsTest : public RenderTest {};

/// An instance that has another mesh and material each time. What no instance is of any more goes sooner or later.
TEST_F(DrawKindsTest, StayFewWhileInstancesTakeOnManyOfThem) {
    constexpr std::uint32_t kLooks = 25;
    scene::World world(boxScene());
    for (std::uint32_t i = 0; i < kLooks; ++i) {
        const float share = static_cast<float>(i) / kLooks;
        world.addMesh(scene::makeBox(glm::vec3(0.4f + 0.4f * share)));
        world.addMaterial({.name = {}, .baseColorFactor = {share, 1.0f - share, 0.5f, 1.0f}});
    }
    const auto lookOf = [&](std::uint32_t mesh, std::uint32_t material) {
        return scene::InstanceOptions{.mesh = world.mesh(1 + mesh % kLooks),
                                      .material = world.material(1 + material % kLooks),
                                      .transform = {{-1.0, 0.0, -5.0}}};
    };
    world.addInstance(
        {.mesh = world.mesh(0), .material = world.material(0), .object = 1, .transform = {{1.0, 0.0, -5.0}}});
    for (const render::Submission submission : submissions()) {
        if (submission == render::Submission::primaries) {
            continue; // reads what secondaries read
        }
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        auto looking = world.addInstance(lookOf(0, 0));
        render::GpuScene onDevice(device(), world);
        render::Renderer renderer(device(), onDevice, options);
        for (std::uint32_t look = 1; look < kLooks * kLooks; ++look) {
            world.removeInstance(looking);
            looking = world.addInstance(lookOf(look, look / kLooks));
            onDevice.update();
            ASSERT_LE(onDevice.uploaded().kinds().size(), 65u);
            if (look % 200 == 0) {
                EXPECT_EQ(renderer.render({}).color.pixels, draw(world.scene(), {}, options).color.pixels)
                    << nameOf(submission) << " " << look;
            }
        }
        world.removeInstance(looking);
    }
}

} // namespace

} // namespace cdr::render_test
