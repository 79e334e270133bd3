#pragma once

#include "failing_calls.h"
#include "fixture.h"

#include <cdr/scene/world/world.h>

#include <functional>
#include <string_view>

namespace cdr::render_test {

/// Edits copies of a world that was drawn. The next frame runs out of memory, at each of its calls of this name in turn. Expects
/// that the frame after it shows what a renderer made anew shows.
/// @return how many calls there are
inline std::size_t expectEditOutlivesFailures(const gpu::Device& device, std::string_view call,
                                              const scene::World& begun,
                                              const std::function<void(scene::World&)>& edit) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.5, .farView = 1000.0};
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored/ratio:1.5"));
    options.motion = true; // keeps vertices, which takes buffers and submissions too
    scene::World edited = begun;
    edit(edited);
    const std::string wanted = hashOf(SoleRenderer(device, edited, options).render(camera));
    EXPECT_NE(hashOf(SoleRenderer(device, begun, options).render(camera)), wanted) << "the edit shows";
    std::size_t failures = 0;
    for (bool hasFailed = true; hasFailed; failures += hasFailed ? 1 : 0) {
        scene::World world = begun;
        SoleRenderer renderer(device, world, options);
        renderer.draw(camera);
        edit(world);
        hasFailed = failsAt(call, failures, [&] { renderer.draw(camera); });
        EXPECT_EQ(hashOf(renderer.render(camera)), wanted) << call << " " << failures;
    }
    return failures;
}

} // namespace cdr::render_test
