#include "../fixture.h"

#include <vector>

namespace cdr::render_test {

namespace {

using EnvironmentTest = RenderTest;

std::vector<scene::Environment> environments(const render::RenderOptions& options) {
    std::vector<scene::Environment> all{
        {.ambient = {0.4f, 0.3f, 0.2f}, .background = {0.1f, 0.2f, 0.5f}},
        {.background = {0.6f, 0.3f, 0.1f}},
        {.ambient = glm::vec3(0.02f)},
    };
    if (options.surface != render::SurfacePath::lit) {
        all.push_back({.background = {0.3f, 0.3f, 0.3f}, .sky = scene::Sky{}});
        all.push_back({.sky = scene::Sky{.zenith = {0.9f, 0.1f, 0.1f}}});
    }
    if (options.surface != render::SurfacePath::lit && !options.focus.isOn()) {
        const scene::Air air{.centre = {0.0, -6'378'137.0 - 2.0, 0.0}};
        all.push_back({.sky = scene::Sky{}, .air = air});
        all.push_back({.air = air});
    }
    all.push_back({});
    return all;
}

/// Day and night: what surrounds a world changes between frames, and each is the one of a scene that was made so.
TEST_F(EnvironmentTest, EachFrameShowsTheSurroundingsOfItsWorld) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -3.0});
    std::vector<render::RenderOptions> variants(4, thumbnailOptions(depth::parseTechnique("anchored")));
    variants[1].surface = render::SurfacePath::visibility;
    variants[2].surface = render::SurfacePath::lit;
    variants[3].targets = render::TargetsKind::layers;
    variants[3].technique = {depth::Mapping::reversed, depth::parseSplit("at:5,15"),
                             depth::DepthFormat::d32f};
    variants[3].focus = {.distance = 3.0, .aperture = 0.1};
    for (render::RenderOptions& options : variants) {
        options.framesInFlight = 2;
        scene::World world(scene);
        SoleRenderer renderer(device(), world, options);
        for (const scene::Environment& environment : environments(options)) {
            renderer.submit({}); // is in flight while the surroundings change
            world.setEnvironment(environment);
            EXPECT_EQ(hashOf(renderer.render({})), hashOf(draw(world.scene(), {}, options)))
                << nameOf(options.surface) << " focus " << options.focus.isOn() << " background "
                << environment.background.x << " sky " << environment.sky.has_value() << " air "
                << environment.air.has_value();
        }
    }
}

} // namespace

} // namespace cdr::render_test
