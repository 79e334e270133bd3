#include "../../support/timeline.h"
#include "../failing_calls.h"
#include "../fixture.h"

#include <cdr/render/views/views_renderer.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace cdr::render_test {

namespace {

using InFlightTest = OwnPipelinesTest;

/// Signals late, so that a test which waits where it should not fails instead of hanging.
class Rescue {
  public:
    explicit Rescue(const test::Timeline& timeline)
        : m_thread([this, &timeline] {
              std::unique_lock lock(m_mutex);
              if (!m_ended.wait_for(lock, std::chrono::seconds(600), [this] { return m_isOver; })) {
                  m_came = true;
                  timeline.signal();
              }
          }) {}
    ~Rescue() {
        end();
        m_thread.join();
    }
    Rescue(const Rescue&) = delete;
    Rescue& operator=(const Rescue&) = delete;

    /// Whether it was needed; it will not be from now on.
    bool end() {
        const std::lock_guard lock(m_mutex);
        m_isOver = true;
        m_ended.notify_all();
        return m_came;
    }

  private:
    std::mutex m_mutex;
    std::condition_variable m_ended;
    bool m_isOver = false;
    bool m_came = false;
    std::thread m_thread;
};

/// Two plain boxes, and one that glows by a texture.
scene::Scene glowingScene() {
    scene::Scene scene = boxScene();
    scene.textures.push_back({.name = "lamp", .pixels = image::ImageRgba8(2, 2, {255, 128, 0, 255})});
    scene.materials.push_back({.name = "lamp",
                               .detail = {.emissive = scene::TextureUse{.texture = 0, .second = false},
                                          .emission = glm::vec3(0.5f)}});
    scene.materials.push_back({.name = "red", .baseColorFactor = {1.0f, 0.0f, 0.0f, 1.0f}});
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.2f)));
    scene::addInstance(scene, 0, 0, 0, {-1.5, 0.0, -5.0}, glm::mat3(1.0f));
    scene::addInstance(scene, 0, 1, 1, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
    scene::addInstance(scene, 1, 2, 2, {1.5, 0.0, -5.0}, glm::mat3(1.0f));
    return scene;
}

/// What changes or goes is kept until the frames that read it are done, and nobody waits for these.
TEST_F(InFlightTest, ChangesAndRemovalsDoNotWaitForFramesInFlight) {
    for (const render::Submission submission : submissions()) {
        scene::World world(glowingScene());
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        options.framesInFlight = 3;
        SoleRenderer renderer(device(), world, options);
        const std::string before = hashOf(renderer.render({}));

        const test::Timeline ready(device());
        const VkSemaphoreSubmitInfo wait = ready.info();
        Rescue rescue(ready);
        renderer.submit({}, {.waits = {&wait, 1}, .signals = {}});
        world.setMaterial(world.material(0), {.name = "blue", .baseColorFactor = {0.0f, 0.0f, 1.0f, 1.0f}});
        scene::Material lamp = world.scene().materials[1];
        lamp.detail.emission = glm::vec3(0.1f);
        world.setMaterial(world.material(1), lamp);
        world.removeInstance(world.instance(2));
        world.removeMaterial(world.material(2));
        world.removeMesh(world.mesh(1));
        renderer.submit({});
        EXPECT_FALSE(rescue.end()) << nameOf(submission);

        ready.signal();
        const std::string after = hashOf(renderer.render({}));
        EXPECT_NE(after, before);
        EXPECT_EQ(after, hashOf(draw(world.scene(), {}, options))) << nameOf(submission);
    }
}

/// A host may still read the last frame's images when the world gets a sky, for which they are made anew.
TEST_F(InFlightTest, ImagesThatAHostMayReadStayUntilTheQueueIsWaitedFor) {
    scene::World world(glowingScene());
    SoleRenderer renderer(device(), world, smallOptions(depth::parseTechnique("anchored")));
    renderer.render({});
    const VkImage before = renderer.surfaces().color.image; // from now on a host may read it
    world.setEnvironment({.sky = scene::Sky{}});
    {
        const FailingCall failing("vkQueueSubmit2"); // of what is waited for
        EXPECT_THROW(renderer.submit({}), vk::OutOfDeviceMemoryError);
        EXPECT_EQ(renderer.surfaces().color.image, before);
    }
    renderer.submit({});
    EXPECT_NE(renderer.surfaces().color.image, before);
}

/// Occluders of one view are drawn and read before anything of another is submitted, which may wait for the host.
TEST_F(InFlightTest, NoViewWaitsForWhatAnotherSubmitted) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0}, glm::mat3(3.0f));
    const render::GpuScene onDevice(device(), scene);
    const std::array cameras{scene::Camera{}, scene::Camera{.position = {0.1, 0.0, 0.0}}};
    for (const bool deviceClock : {false, true}) { // views are drawn together, and in turn
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.occlusionCulling = true;
        options.deviceClock = deviceClock;
        render::ViewsRenderer renderer(device(), scene, onDevice, options, 2);
        renderer.draw(cameras);
        EXPECT_GT(renderer.draw(cameras)[1].occluders.draws, 0u);

        const test::Timeline ready(device());
        const VkSemaphoreSubmitInfo wait = ready.info();
        Rescue rescue(ready);
        renderer.submit(cameras, {.waits = {&wait, 1}, .signals = {}});
        EXPECT_FALSE(rescue.end()) << deviceClock;
        ready.signal();
        renderer.finish();
    }
}

} // namespace

} // namespace cdr::render_test
