#include "../fixture.h"

#include <cdr/render/views/views_renderer.h>

#include <span>

namespace cdr::render_test {

namespace {

using ViewsRoomTest = RenderTest;

/// Boxes before the camera and behind it, and panes before it: more fragments than lists have room for at first.
scene::Scene boxesAndPanes() {
    scene::Scene scene = boxScene();
    scene.materials.push_back(
        {.name = "glass", .baseColorFactor = glm::vec4(0.5f), .alphaMode = scene::AlphaMode::blend});
    for (int column = -3; column <= 3; ++column) {
        addBox(scene, {1.5 * column, 0.0, -8.0});
        addBox(scene, {1.5 * column, 0.0, 8.0});
    }
    for (int pane = 0; pane < 6; ++pane) {
        scene::addInstance(scene, 0, 1, 100, {0.0, 0.0, -20.0 - pane},
                           glm::mat3(glm::vec3(90.0f, 0.0f, 0.0f), glm::vec3(0.0f, 90.0f, 0.0f),
                                     glm::vec3(0.0f, 0.0f, 0.1f)));
    }
    return scene;
}

/// The last frame's lists get more room when the next one is drawn.
TEST_F(ViewsRoomTest, AFrameThatLackedRoomLeavesTheNextOneAsItIs) {
    const scene::Scene scene = boxesAndPanes();
    const render::GpuScene onDevice(device(), scene);
    const scene::Camera ahead{.farView = 1000.0};
    const scene::Camera behind = scene::lookAlong(ahead, ahead.position, {0.0, 0.0, 1.0});
    for (const bool deviceClock : {false, true}) { // views are drawn together, and in turn
        render::RenderOptions options = withSorting(thumbnailOptions(depth::parseTechnique("reversed")));
        options.deviceClock = deviceClock;
        const std::string wanted = hashOf(draw(scene, behind, options));
        render::ViewsRenderer renderer(device(), scene, onDevice, options, 1);
        renderer.submit(std::span(&ahead, 1));
        EXPECT_EQ(hashOf(renderer.render(std::span(&behind, 1)).front()), wanted);
    }
}

} // namespace

} // namespace cdr::render_test
