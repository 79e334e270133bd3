#include "failing_calls.h"
#include "fixture.h"

#include <cdr/render/views/views_renderer.h>
#include <cdr/scene/world/world.h>

#include <array>
#include <span>
#include <system_error>

namespace cdr::render_test {

namespace {

scene::Camera cameraAt(double x) {
    scene::Camera camera;
    camera.position = {x, 0.0, 0.0};
    camera.farView = 1000.0;
    return camera;
}

/// After an error all is as the last frame that was drawn left it.
class FailedFrameTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        addBox(m_scene, {0.0, 0.0, -5.0});
        m_onDevice.emplace(device(), m_scene);
    }

    static render::RenderOptions options() {
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored/ratio:1.5"));
        options.motion = true;
        return options;
    }

    static void expectSame(const render::Surfaces& now, const render::Surfaces& before) {
        EXPECT_EQ(now.color.image, before.color.image);
        EXPECT_EQ(now.color.layout, before.color.layout);
        EXPECT_EQ(now.gbuffer.layout, before.gbuffer.layout);
        EXPECT_EQ(now.motion.layout, before.motion.layout);
        EXPECT_EQ(now.anchorsView, before.anchorsView);
    }

    scene::Scene m_scene = boxScene();
    std::optional<render::GpuScene> m_onDevice;
};

/// However far it came: once the mesh is gone that had no room, or there is room for it, all others are there.
TEST_F(FailedFrameTest, MeshesOutliveAnUploadWithoutMemory) {
    const std::string wanted = hashOf(draw(m_scene, cameraAt(0.0), options()));
    std::size_t failures = 0;
    for (bool hasFailed = true; hasFailed; failures += hasFailed ? 1 : 0) {
        for (const bool goes : {true, false}) {
            scene::World world(m_scene);
            render::GpuScene onDevice(device(), world);
            const scene::MeshHandle mesh = world.addMesh(scene::makeBox(glm::vec3(1.0f)));
            {
                const FailingCall failing("vkCreateBuffer", failures);
                try {
                    onDevice.update();
                } catch (const base::RunError&) {
                }
                hasFailed = FailingCall::hasFailed();
            }
            if (goes) {
                world.removeMesh(mesh);
            }
            render::Renderer renderer(device(), onDevice, options());
            EXPECT_EQ(hashOf(renderer.render(cameraAt(0.0))), wanted) << "buffer " << failures;
        }
    }
    EXPECT_GE(failures, 3u); // vertices, indices, and what takes them there
    EXPECT_EQ(messageCount(), 0u);
}

} // namespace

} // namespace cdr::render_test
