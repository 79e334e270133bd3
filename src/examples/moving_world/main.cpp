// A world that changes between frames: a row of boxes 1,000 km away, drawn with anchored depth and read back. A misuse is
// an error with a name.
#include <cdr/base/error.h>
#include <cdr/render/renderer.h>

#include <cstdint>
#include <cstdio>
#include <vector>

int main() try {
    namespace base = cdr::base;
    namespace depth = cdr::depth;
    namespace gpu = cdr::gpu;
    namespace render = cdr::render;
    namespace scene = cdr::scene;

    // quoted in src/cdr/README.md: begin
    const gpu::Instance instance;
    const gpu::Device device(instance, ""); // the best device, or one by part of its name

    scene::World world; // or of a scene::Scene, from glTF for example
    const scene::MeshHandle box = world.addMesh(scene::makeBox(glm::vec3(0.5f)));
    const scene::MaterialHandle paint = world.addMaterial({.baseColorFactor = {0.8f, 0.2f, 0.1f, 1.0f}});
    world.addLight({.position = {0.0, 1e6, 0.0}, .halfDistance = 1e6});
    std::vector<scene::InstanceHandle> boxes;
    for (std::uint32_t i = 0; i < 5; ++i) {
        boxes.push_back(world.addInstance({.mesh = box, .material = paint, .object = i}));
    }

    render::GpuScene onDevice(device, world);
    render::Renderer renderer(device, onDevice,
                              {.width = 320, .height = 180, .technique = depth::parseTechnique("anchored")});
    const scene::Camera camera{.fovY = 1e-5, .nearView = 1.0, .farView = 1e8};
    for (int turn = 0; turn < 3; ++turn) {
        std::vector<scene::Transform> moved; // each box 0.00001 units behind the one before
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const auto front = static_cast<double>((i + static_cast<std::size_t>(turn)) % boxes.size());
            moved.push_back({.position = {0.0, 0.0, -1e6 - 1e-5 * front}});
        }
        world.setTransforms(boxes, moved); // all of them or none, before the next frame
        const render::Frame frame = renderer.render(camera);
        std::printf("turn %d: id %u at %.6f\n", turn, frame.id(160, 90), frame.distanceView(160, 90));
    }
    world.removeInstance(boxes.back());
    // quoted in src/cdr/README.md: end
    try {
        world.setTransform(boxes.back(), {});
    } catch (const base::InputError& error) {
        std::printf("%s\n", error.what());
    }
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
