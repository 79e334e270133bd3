#include <cdr/render/renderer.h>
#include <scenes/cubes.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

/// What the README shows of the library compiles, and does what its comments say.
TEST(LibraryExample, FindsAnObjectAndItsDistance) {
    // quoted in README.md: begin
    const cdr::gpu::Instance instance;
    const cdr::gpu::Device device(instance, ""); // the best there is; gpu::BorrowedDevice takes yours
    const cdr::scene::SceneSetup setup = cdr::scenes::makeAfc(2013);
    const cdr::render::GpuScene onDevice(device, setup.scene);
    cdr::render::Renderer renderer(device, setup.scene, onDevice,
                                   {.technique = cdr::depth::parseTechnique("anchored")});
    const cdr::render::Frame frame = renderer.render(setup.path.at(0));
    const std::uint32_t id = frame.id(640, 360);          // object index + 1, 0 for the background
    const double distance = frame.distanceView(640, 360); // float64, in scene units, for every technique
    // quoted in README.md: end
    ASSERT_NE(id, 0u);
    EXPECT_LE(id, setup.scene.instances.size());
    EXPECT_NEAR(distance, 1e6, 32.0);
}

} // namespace
