#include <cdr/visibility/cull.h>
#include <cdr/visibility/sphere_test.h>

#include <algorithm>
#include <array>

namespace cdr::visibility {

namespace {

void resize(VisibleList& visible, std::size_t count) {
    visible.instance.resize(count);
    visible.distanceView.resize(count);
    visible.radius.resize(count);
}

} // namespace

void cullSpheres(const scene::Instances& instances, std::span<const std::uint32_t> some,
                 const scene::Camera& camera, const scene::Frustum& frustum, VisibleList& visible) {
    const SphereTest test(camera, frustum);
    resize(visible, some.size());
    visible.count = 0;
    TestedSpheres block;
    std::array<double, kTestBlock> x;
    std::array<double, kTestBlock> y;
    std::array<double, kTestBlock> z;
    std::array<float, kTestBlock> radius;
    for (std::size_t begin = 0; begin < some.size(); begin += kTestBlock) {
        const std::span<const std::uint32_t> tested =
            some.subspan(begin, std::min(kTestBlock, some.size() - begin));
        for (std::size_t i = 0; i < tested.size(); ++i) {
            x[i] = instances.x[tested[i]];
            y[i] = instances.y[tested[i]];
            z[i] = instances.z[tested[i]];
            radius[i] = instances.radius[tested[i]];
        }
        testSpheres(test, {x.data(), y.data(), z.data(), radius.data()}, tested.size(), block);
        for (std::size_t i = 0; i < tested.size(); ++i) {
            visible.instance[visible.count] = tested[i];
            visible.distanceView[visible.count] = block.distanceView[i];
            visible.radius[visible.count] = radius[i];
            visible.count += block.margin[i] >= 0.0 ? 1 : 0;
        }
    }
}

} // namespace cdr::visibility
