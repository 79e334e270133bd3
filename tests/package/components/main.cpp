// Takes a world to pieces and cuts what is visible of it into cascades, without a device.
#include <cdr/depth/make_cascades.h>
#include <cdr/scene/world/world.h>

#include <cstdio>
#include <exception>
#include <vector>

int main() try {
    using namespace cdr;

    scene::World world;
    const scene::MeshHandle box = world.addMesh(scene::makeBox(glm::vec3(0.5f)));
    const scene::MaterialHandle paint = world.addMaterial({});
    for (const double distanceView : {10.0, 1e6}) {
        world.addInstance(
            {.mesh = box, .material = paint, .transform = {.position = {0.0, 0.0, -distanceView}}});
    }
    const scene::Instances& instances = world.scene().instances;
    std::vector<depth::Interval> visible;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        visible.push_back({-instances.z[i] - instances.radius[i], -instances.z[i] + instances.radius[i]});
    }
    const depth::Cascades cascades = depth::makeCascades(
        depth::SplitFitted{}, {.nearView = 0.1,
                               .farView = 1e7,
                               .model = {depth::Mapping::anchored, depth::DepthFormat::d32f},
                               .footprintSlope = 0.001,
                               .visible = visible});
    std::printf("%zu instances in %zu cascades\n", instances.size(), cascades.size());
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
