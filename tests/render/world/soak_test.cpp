#include "../fixture.h"

#include <cdr/gpu/memory.h>
#include <cdr/scene/world/world.h>

#include <malloc.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <vector>

namespace cdr::render_test {

namespace {

using scene::World;

constexpr std::size_t kMovers = 20;
constexpr std::size_t kFramesOfCycle = 8;

struct Memory {
    std::uint64_t host = 0;
    std::uint64_t device = 0;
};

Memory memoryOf(const gpu::Device& device) {
    const struct mallinfo2 info = mallinfo2();
    return {.host = info.uordblks + info.hblkhd, .device = gpu::allocatedDeviceBytes(device)};
}

/// Edits of a world that comes back to what it was: each kind of thing is added, changed and removed.
class Cycle {
  public:
    explicit Cycle(World& world) : m_world(world) {}

    /// What is done in front of a frame of the cycle.
    void edit(std::size_t frame) {
        switch (frame) {
        case 0:
            addLooks();
            break;
        case 1:
            addMovers();
            break;
        case 2:
        case 3:
        case 4:
            move(static_cast<double>(frame));
            break;
        case 5:
            change();
            break;
        case 6:
            removeMovers();
            break;
        default:
            removeLooks();
        }
    }

  private:
    void addLooks() {
        scene::Mesh mesh = scene::makeBox(glm::vec3(0.25f));
        m_vertices = mesh.vertices;
        m_mesh = m_world.addMesh(std::move(mesh));
        const image::ImageRgba8 grey(4, 4, {128, 128, 128, 255});
        m_texture = m_world.addTexture({.name = "grey", .pixels = grey});
        m_material = m_world.addMaterial({.name = "soaked", .baseColorTexture = m_texture.index});
        m_light = m_world.addLight({.position = glm::dvec3(0.0, 3.0, 0.0), .halfDistance = 5.0});
    }
    void addMovers() {
        for (std::uint32_t i = 0; i < kMovers; ++i) {
            m_movers.push_back(
                m_world.addInstance({.mesh = m_mesh, .material = m_material, .object = 10 + i}));
        }
    }
    void move(double frame) {
        std::vector<scene::Transform> transforms(m_movers.size());
        for (std::size_t i = 0; i < transforms.size(); ++i) {
            transforms[i].position = {0.2 * static_cast<double>(i) - 2.0, 0.3 * frame - 1.0, -3.0 * frame};
        }
        m_world.setTransforms(m_movers, transforms);
    }
    void change() {
        std::vector<scene::Vertex> larger = m_vertices;
        for (scene::Vertex& vertex : larger) {
            vertex.position *= 1.5f;
        }
        m_world.setVertices(m_mesh, std::move(larger));
        scene::Material white{.name = "soaked"};
        m_world.setMaterial(m_material, white);
        m_world.setLight(m_light, {.position = glm::dvec3(1.0, 3.0, 0.0), .halfDistance = 9.0});
    }
    void removeMovers() {
        for (const scene::InstanceHandle mover : m_movers) {
            m_world.removeInstance(mover);
        }
        m_movers.clear();
    }
    void removeLooks() {
        m_world.removeMaterial(m_material);
        m_world.removeTexture(m_texture);
        m_world.removeMesh(m_mesh);
        m_world.removeLight(m_light);
    }

    World& m_world;
    std::vector<scene::Vertex> m_vertices;
    scene::MeshHandle m_mesh;
    scene::TextureHandle m_texture;
    scene::MaterialHandle m_material;
    scene::LightHandle m_light;
    std::vector<scene::InstanceHandle> m_movers;
};

render::RenderOptions soaked(render::Submission submission) {
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored/count:3"), 32, 18);
    options.submission = submission;
    options.threads = 2;
    options.framesInFlight = 3;
    options.prepareFor.lights = 2;
    return options;
}

/// Frames until the driver has what it keeps: on a busy machine llvmpipe takes another 1 % after the first hundreds.
constexpr std::size_t kWarmUpFrames = 1'600;

/// A world that is edited in front of each frame takes no more memory at the end than after the warm-up, within 1 %.
/// CDR_ALL_CASES draws 100,000 frames instead of 3,200. Without validation, which keeps 3.5 KB a frame itself (1.3.239).
TEST(WorldSoakTest, EditsLeaveNoMemoryBehind) {
    const gpu::Instance instance;
    const gpu::Device device(instance, "");
    const std::size_t cycles = (std::getenv("CDR_ALL_CASES") != nullptr ? 100'000 : 3'200) / kFramesOfCycle;
    scene::Scene scene = boxScene();
    addBox(scene, glm::dvec3(0.0, 0.0, -10.0));
    World world(std::move(scene));
    render::GpuScene onDevice(device, world);
    std::vector<std::unique_ptr<render::Renderer>> renderers;
    for (const render::Submission submission : render::kSubmissions) {
        if (submission == render::Submission::gpuDriven && !device.info().gpuDrivenMissing.empty()) {
            continue;
        }
        renderers.push_back(std::make_unique<render::Renderer>(device, onDevice, soaked(submission)));
    }
    Cycle cycle(world);
    std::vector<Memory> memory;
    memory.reserve(cycles);
    for (std::size_t done = 0; done < cycles; ++done) {
        for (std::size_t frame = 0; frame < kFramesOfCycle; ++frame) {
            cycle.edit(frame);
            renderers[(done + frame) % renderers.size()]->submit({.fovY = 1.0});
        }
        for (const auto& renderer : renderers) {
            renderer->finish();
        }
        memory.push_back(memoryOf(device));
    }
    // The least of several, since what is measured goes up and down within the driver.
    const auto least = [&](std::size_t from, std::uint64_t Memory::*bytes) {
        const auto first = memory.begin() + static_cast<std::ptrdiff_t>(from);
        const auto found =
            std::min_element(first, first + static_cast<std::ptrdiff_t>(cycles / 10),
                             [bytes](const Memory& a, const Memory& b) { return a.*bytes < b.*bytes; });
        return static_cast<double>((*found).*bytes);
    };
    for (std::uint64_t Memory::*bytes : {&Memory::host, &Memory::device}) {
        const double before = least(kWarmUpFrames / kFramesOfCycle, bytes);
        const double after = least(cycles - cycles / 10, bytes);
        EXPECT_GT(before, 0.0) << "nothing is counted";
        EXPECT_LE(after, 1.01 * before) << (bytes == &Memory::host ? "host" : "device");
        std::cout << (bytes == &Memory::host ? "host" : "device") << " bytes grew from " << before << " to "
                  << after << " over " << cycles * kFramesOfCycle << " frames\n";
    }
}

} // namespace

} // namespace cdr::render_test
