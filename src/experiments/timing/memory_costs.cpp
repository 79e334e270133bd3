#include "memory_costs.h"

#include <cdr/gpu/memory.h>
#include <cdr/render/draw_source.h>
#include <cdr/render/renderer.h>
#include <cdr/render/renderer_setup.h>
#include <cdr/render/targets/gbuffer.h>
#include <cdr/render/targets/gbuffer_pixel.h>
#include <cdr/visibility/instance_cells.h>
#include <scenes/cubes.h>

#include <program/allocator.h>

#include <functional>
#include <memory>

namespace cdr::experiments {

namespace {

/// What `make` leaves on the heap, for as long as what it returns lives.
template <typename Make>
double heapTaken(const Make& make) {
    const auto bytes = [] { return static_cast<double>(program::allocatedBytes().value_or(0)); };
    const double before = bytes();
    const auto made = make();
    return bytes() - before;
}

/// Bytes of what grows with instances, by one of them: twice as many over as many.
double bytesPerInstance(const MemoryOptions& options,
                        const std::function<double(const scene::Scene&)>& taken) {
    const scene::SceneSetup few = scenes::makeRotation(options.seed, options.instances);
    const scene::SceneSetup many = scenes::makeRotation(options.seed, 2 * options.instances);
    taken(few.scene); // what the first use makes, stays
    return (taken(many.scene) - taken(few.scene)) / options.instances;
}

/// A copy has no room to spare, as what is made step by step has.
double heapOfCopy(const scene::Scene& scene) {
    return heapTaken([&] { return std::make_unique<scene::Instances>(scene.instances); });
}

double heapOfUpload(const gpu::Device& device, const scene::Scene& scene) {
    return heapTaken([&] { return std::make_unique<render::GpuScene>(device, scene); });
}

double heapOfCells(const scene::Scene& scene) {
    platform::WorkerPool workers(1);
    return heapTaken([&] {
        auto cells = std::make_unique<visibility::InstanceCells>();
        cells->build(scene, workers);
        return cells;
    });
}

/// Per instance, of full cells.
double predictedCells() {
    using Cells = visibility::InstanceCells;
    constexpr double kSpheres = 3 * sizeof(double) + sizeof(float);
    constexpr double kIndices = 2 * sizeof(std::uint32_t); // which instance, and where it is
    constexpr double kHome = 4 * sizeof(double);
    constexpr double kBoxes = sizeof(Cells::Box) * Cells::kFan / (Cells::kFan - 1.0); // of all levels
    return kSpheres + kIndices + (kHome + kBoxes + sizeof(std::uint64_t)) / Cells::kCellSlots;
}

double predictedInstance() {
    return 3 * sizeof(double) + sizeof(float) + sizeof(glm::mat3) + 3 * sizeof(std::uint32_t);
}

render::RenderOptions optionsOf(const MemoryOptions& options, std::uint32_t width,
                                const render::TargetsChoice& targets) {
    render::RenderOptions render{
        .width = width, .height = options.height, .technique = depth::parseTechnique("cdr")};
    render.technique.split = depth::SplitCount{options.cascades};
    render.targets = targets;
    return render;
}

/// What a renderer takes of the device once it has drawn a frame.
struct Taken {
    double bytes = 0.0;
    double draws = 0.0; ///< of that frame
};

Taken deviceTaken(const gpu::Device& device, const scene::SceneSetup& setup, const render::GpuScene& uploaded,
                  const render::RenderOptions& options) {
    const std::uint64_t before = gpu::allocatedDeviceBytes(device);
    render::Renderer renderer(device, setup.scene, uploaded, options);
    const auto draws = static_cast<double>(renderer.draw(setup.path.at(0)).draws);
    return {.bytes = static_cast<double>(gpu::allocatedDeviceBytes(device)) - static_cast<double>(before),
            .draws = draws};
}

double bytesPerDraw(const gpu::Device& device, const MemoryOptions& options) {
    constexpr std::uint32_t kDraws = 40'000;
    const auto taken = [&](std::uint32_t draws) {
        const scene::SceneSetup setup = scenes::makeCrowd(options.seed, draws);
        const render::GpuScene uploaded(device, setup.scene);
        return deviceTaken(device, setup, uploaded,
                           optionsOf(options, options.width, render::TargetsKind::single));
    };
    const Taken few = taken(kDraws);
    const Taken many = taken(2 * kDraws);
    return (many.bytes - few.bytes) / (many.draws - few.draws);
}

/// Geometry buffers beside the final one.
std::size_t layersOf(const render::TargetsChoice& targets, unsigned cascades) {
    switch (targets.kind) {
    case render::TargetsKind::accumulate:
        return 1;
    case render::TargetsKind::pool:
        return targets.layers;
    case render::TargetsKind::layers:
        return cascades;
    default:
        return 0;
    }
}

MemoryCost pixelCost(const gpu::Device& device, const MemoryOptions& options,
                     const render::TargetsChoice& targets) {
    const scene::SceneSetup setup = scenes::makeCrowd(options.seed, 100);
    const render::GpuScene uploaded(device, setup.scene);
    const render::RenderOptions once = optionsOf(options, options.width, targets);
    const render::RenderOptions twice = optionsOf(options, 2 * options.width, targets);
    const double pixels = static_cast<double>(options.width) * options.height;
    const auto layers = static_cast<double>(layersOf(targets, options.cascades));
    constexpr double kColor = sizeof(render::GBufferPixel);
    const double layer = static_cast<double>(render::predictLayerBytes(
                             device, {options.width, options.height}, once.technique.format)) /
                         pixels;
    const double picture = static_cast<double>(render::predictPictureBytes(device, once, {})) / pixels;
    // The first layer has the final depth buffer for its own.
    const double sharedDepth = layers > 0.0 ? layer - kColor : 0.0;
    return {.what = "targets " + nameOf(targets),
            .per = "pixel",
            .on = "device",
            .predictedBytes = picture + layers * layer - sharedDepth,
            .measuredBytes = (deviceTaken(device, setup, uploaded, twice).bytes -
                              deviceTaken(device, setup, uploaded, once).bytes) /
                             pixels};
}

} // namespace

std::vector<MemoryCost> measureMemory(const gpu::Device& device, const MemoryOptions& options) {
    constexpr double kDrawRoom = 1.5; // gpu::roomToGrow()
    std::vector<MemoryCost> costs{
        {"scene", "instance", "host", predictedInstance(), bytesPerInstance(options, heapOfCopy)},
        {"draw source", "instance", "host", sizeof(render::DrawSource),
         bytesPerInstance(options, [&](const scene::Scene& scene) { return heapOfUpload(device, scene); })},
        {"cells", "instance", "host", predictedCells(), bytesPerInstance(options, heapOfCells)},
        {"draw record", "draw", "device", kDrawRoom * sizeof(shaders::DrawRecord),
         bytesPerDraw(device, options)}};
    for (const render::TargetsKind kind : render::kTargetsKinds) {
        costs.push_back(pixelCost(device, options, kind));
    }
    return costs;
}

} // namespace cdr::experiments
