#include <cdr/visibility/cull.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::visibility {

namespace {

/// Instances tested together: the working set stays in the first-level cache and the loop over it is
/// vectorised.
constexpr std::size_t kTestBlock = 512;
/// Instances per job where threads share them: enough work to be worth a hand-off.
constexpr std::size_t kTestJobInstances = 16'384;

/// A camera as the test wants it. The frustum is symmetric, so two side planes each stand for two.
struct SphereTest {
    glm::dvec3 position, right, up, back;
    double cosX, sinX, cosY, sinY, nearView, farView;

    SphereTest(const scene::Camera& camera, const scene::Frustum& frustum)
        : position(camera.position),
          right(camera.right),
          up(camera.up),
          back(camera.back),
          cosX(frustum.cosX),
          sinX(frustum.sinX),
          cosY(frustum.cosY),
          sinY(frustum.sinY),
          nearView(camera.nearView),
          farView(camera.farView) {}
};

/// The part of instances that the test reads.
struct Spheres {
    const double* x;
    const double* y;
    const double* z;
    const float* radius;
};

struct TestBlock {
    std::array<double, kTestBlock> distanceView;
    std::array<double, kTestBlock> margin; ///< below 0: outside one of the planes
};

/// The hot loop: straight-line arithmetic over arrays, no branch, so compilers vectorise it. They do so only
/// where they know that writing the block changes neither the test nor the pointers, hence the copies.
void testBlock(const SphereTest test, const Spheres spheres, std::size_t count, TestBlock& block) {
    const auto [x, y, z, radius] = spheres;
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x[i] - test.position.x;
        const double dy = y[i] - test.position.y;
        const double dz = z[i] - test.position.z;
        const double vx = dx * test.right.x + dy * test.right.y + dz * test.right.z;
        const double vy = dx * test.up.x + dy * test.up.y + dz * test.up.z;
        const double w = -(dx * test.back.x + dy * test.back.y + dz * test.back.z);
        const double sideX = w * test.sinX - std::abs(vx) * test.cosX;
        const double sideY = w * test.sinY - std::abs(vy) * test.cosY;
        const double depth = std::min(w - test.nearView, test.farView - w);
        block.distanceView[i] = w;
        block.margin[i] = std::min(std::min(sideX, sideY), depth) + static_cast<double>(radius[i]);
    }
}

/// Appends the survivors of a range to arrays sized for all of it; returns how many.
std::size_t cullRange(const SphereTest& test, const scene::Instances& instances, host::IndexRange range,
                      VisibleList& visible) {
    TestBlock block;
    std::size_t kept = range.begin;
    for (std::size_t begin = range.begin; begin < range.end; begin += kTestBlock) {
        const std::size_t count = std::min(kTestBlock, range.end - begin);
        testBlock(test,
                  {instances.x.data() + begin, instances.y.data() + begin, instances.z.data() + begin,
                   instances.radius.data() + begin},
                  count, block);
        for (std::size_t i = 0; i < count; ++i) {
            // Written always, kept or overwritten: cheaper than a branch nobody can predict.
            visible.instance[kept] = static_cast<std::uint32_t>(begin + i);
            visible.distanceView[kept] = block.distanceView[i];
            visible.radius[kept] = instances.radius[begin + i];
            kept += block.margin[i] >= 0.0 ? 1 : 0;
        }
    }
    return kept - range.begin;
}

void resize(VisibleList& visible, std::size_t count) {
    visible.instance.resize(count);
    visible.distanceView.resize(count);
    visible.radius.resize(count);
}

template <typename T>
void closeGap(std::vector<T>& values, std::size_t from, std::size_t count, std::size_t to) {
    if (from == to) {
        return;
    }
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(from), count,
                values.begin() + static_cast<std::ptrdiff_t>(to));
}

} // namespace

void cullSpheres(const scene::Instances& instances, const scene::Camera& camera,
                 const scene::Frustum& frustum, host::WorkerPool& workers, VisibleList& visible) {
    const SphereTest test(camera, frustum);
    const std::size_t count = instances.size();
    resize(visible, count);
    // One thread takes all in one job, which leaves no gap to close.
    const std::size_t jobs = workers.threads() == 1 ? 1 : (count + kTestJobInstances - 1) / kTestJobInstances;
    std::vector<std::size_t> kept(jobs);
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        kept[job] = cullRange(test, instances, host::evenRange(count, job, jobs), visible);
    });
    std::size_t end = 0;
    for (std::size_t job = 0; job < jobs; ++job) {
        const std::size_t begin = host::evenRange(count, job, jobs).begin;
        closeGap(visible.instance, begin, kept[job], end);
        closeGap(visible.distanceView, begin, kept[job], end);
        closeGap(visible.radius, begin, kept[job], end);
        end += kept[job];
    }
    visible.count = end;
}

void cullSpheres(const scene::Instances& instances, std::span<const std::uint32_t> some,
                 const scene::Camera& camera, const scene::Frustum& frustum, VisibleList& visible) {
    const SphereTest test(camera, frustum);
    resize(visible, some.size());
    visible.count = 0;
    TestBlock block;
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
        testBlock(test, {x.data(), y.data(), z.data(), radius.data()}, tested.size(), block);
        for (std::size_t i = 0; i < tested.size(); ++i) {
            visible.instance[visible.count] = tested[i];
            visible.distanceView[visible.count] = block.distanceView[i];
            visible.radius[visible.count] = radius[i];
            visible.count += block.margin[i] >= 0.0 ? 1 : 0;
        }
    }
}

void removeInstances(std::span<const std::uint32_t> instances, VisibleList& visible) {
    auto next = instances.begin();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < visible.count; ++i) {
        next = std::find_if(next, instances.end(),
                            [&](std::uint32_t removed) { return removed >= visible.instance[i]; });
        if (next != instances.end() && *next == visible.instance[i]) {
            continue;
        }
        visible.instance[kept] = visible.instance[i];
        visible.distanceView[kept] = visible.distanceView[i];
        visible.radius[kept] = visible.radius[i];
        ++kept;
    }
    visible.count = kept;
}

} // namespace cdr::visibility
