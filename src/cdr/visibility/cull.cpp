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

    SphereTest(const scene::Camera& camera, double aspect)
        : position(camera.position),
          right(camera.right),
          up(camera.up),
          back(camera.back),
          nearView(camera.nearView),
          farView(camera.farView) {
        const double halfY = 0.5 * camera.fovY;
        const double halfX = std::atan(std::tan(halfY) * aspect);
        cosX = std::cos(halfX);
        sinX = std::sin(halfX);
        cosY = std::cos(halfY);
        sinY = std::sin(halfY);
    }
};

struct TestBlock {
    std::array<double, kTestBlock> distanceView;
    std::array<double, kTestBlock> margin; ///< below 0: outside one of the planes
};

/// The hot loop: straight-line arithmetic over arrays, no branch, so compilers vectorise it.
void testBlock(const SphereTest& test, const scene::Instances& instances, std::size_t begin,
               std::size_t count, TestBlock& block) {
    const double* x = instances.x.data() + begin;
    const double* y = instances.y.data() + begin;
    const double* z = instances.z.data() + begin;
    const float* radius = instances.radius.data() + begin;
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
        testBlock(test, instances, begin, count, block);
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

template <typename T>
void closeGap(std::vector<T>& values, std::size_t from, std::size_t count, std::size_t to) {
    if (from == to) {
        return;
    }
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(from), count,
                values.begin() + static_cast<std::ptrdiff_t>(to));
}

} // namespace

void cullSpheres(const scene::Instances& instances, const scene::Camera& camera, double aspect,
                 host::WorkerPool& workers, VisibleList& visible) {
    const SphereTest test(camera, aspect);
    const std::size_t count = instances.size();
    visible.instance.resize(count);
    visible.distanceView.resize(count);
    visible.radius.resize(count);
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

} // namespace cdr::visibility
