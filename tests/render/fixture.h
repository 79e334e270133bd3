#pragma once

#include "../support/refusal.h"
#include "../support/shared_device.h"

#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>

#include <gtest/gtest.h>
#include <program/sha256.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::render_test {

/// What rays in float64 find; without a size, for a picture of smallOptions().
inline measure::TruthImage truthOf(const scene::Scene& scene, const scene::Camera& camera,
                                   std::uint32_t width = 480, std::uint32_t height = 270) {
    platform::WorkerPool workers(2);
    return measure::castTruth(scene, camera, width, height, workers);
}

/// What one renderer alone draws, on the device.
struct SoleScene {
    render::GpuScene onDevice;
};

/// A renderer of a scene or a world that has no other.
class SoleRenderer : SoleScene, public render::Renderer {
  public:
    SoleRenderer(const gpu::Device& device, const scene::Scene& scene, const render::RenderOptions& options)
        : SoleScene{render::GpuScene(device, scene)},
          Renderer(device, scene, onDevice, options) {}
    SoleRenderer(const gpu::Device& device, const scene::World& world, const render::RenderOptions& options)
        : SoleScene{render::GpuScene(device, world)},
          Renderer(device, onDevice, options) {}
};

/// One hash over all that a frame holds pixel by pixel, but motion: that depends on the frame before.
inline std::string hashOf(const render::Frame& frame) {
    return program::sha256Of(frame.color.pixels) + program::sha256Of(frame.linear.pixels) +
           program::sha256Of(frame.gbuffer.pixels) + program::sha256Of(frame.litMask.pixels) +
           program::sha256Of(frame.fragmentCounts.pixels);
}

class RenderTest : public test::DeviceTest {
  protected:
    /// The submissions that the device serves.
    std::vector<render::Submission> submissions() {
        std::vector<render::Submission> all(render::kSubmissions.begin(), render::kSubmissions.end());
        if (!canDrawGpuDriven()) {
            std::erase(all, render::Submission::gpuDriven);
        }
        return all;
    }

    /// Whether the device reads as many facets of boxes, two texels each.
    bool readsFacetsOf(const scene::Scene& scene) {
        return scene.instances.size() * 6 * 2 <=
               vk::PhysicalDevice(device().physical()).getProperties().limits.maxTexelBufferElements;
    }

    /// Why there is no renderer of a scene with these options; "none" where there is one.
    std::string refusalOf(const scene::Scene& scene, const render::RenderOptions& options) {
        const render::GpuScene gpuScene(device(), scene);
        return test::inputErrorOf(
            [&] { const render::Renderer renderer(device(), scene, gpuScene, options); }, "none");
    }

    render::Frame draw(const scene::Scene& scene, const render::GpuScene& gpuScene,
                       const scene::Camera& camera, const render::RenderOptions& options) {
        return render::Renderer(device(), scene, gpuScene, options).render(camera);
    }
    render::Frame draw(const scene::Scene& scene, const scene::Camera& camera,
                       const render::RenderOptions& options) {
        return draw(scene, render::GpuScene(device(), scene), camera, options);
    }

    measure::WrongPixels wrongIn(const render::Frame& frame, const scene::Scene& scene,
                                 const scene::Camera& camera) {
        return measure::countWrong(frame.ids(), truthOf(scene, camera, frame.width(), frame.height()));
    }

    /// Expects one picture to the bit, however its cascades meet and its draws are submitted and batched.
    void expectOnePicture(const scene::Scene& scene, const scene::Camera& camera,
                          const render::RenderOptions& options) {
        const render::GpuScene gpuScene(device(), scene);
        const std::string wanted = hashOf(draw(scene, gpuScene, camera, options));
        const auto expectSame = [&](std::string_view what, const auto& change) {
            render::RenderOptions other = options;
            other.threads = 4;
            change(other);
            EXPECT_EQ(hashOf(draw(scene, gpuScene, camera, other)), wanted)
                << nameOf(other.technique) << " " << what;
        };
        for (const char* targets : {"accumulate", "pool:2", "layers"}) {
            expectSame(targets, [&](auto& other) { other.targets = render::parseTargets(targets); });
        }
        for (const render::Submission submission : submissions()) {
            expectSame(nameOf(submission), [&](auto& other) { other.submission = submission; });
        }
        for (const render::Batching batching : render::kBatchings) {
            expectSame(nameOf(batching), [&](auto& other) { other.batching = batching; });
        }
    }
};

/// Skipped where the device deforms nothing.
class DeformTest : public RenderTest {
  protected:
    void SetUp() override {
        if (!device().info().deformMissing.empty()) {
            GTEST_SKIP() << "the device lacks " << device().info().deformMissing.front();
        }
    }
};

/// Nothing has a pipeline but the renderers that draw with it.
class OwnPipelinesTest : public RenderTest {
  protected:
    void SetUp() override { gpu::releasePipelines(device()); }
    void TearDown() override {
        gpu::keepPipelines(device());
        RenderTest::TearDown();
    }
};

inline render::RenderOptions smallOptions(const depth::Technique& technique, std::uint32_t width = 480,
                                          std::uint32_t height = 270) {
    return {.width = width,
            .height = height,
            .technique = technique,
            .targets = render::TargetsKind::single,
            .threads = 1};
}

/// The same for a quarter of the pixels.
inline render::RenderOptions quarterOf(render::RenderOptions options) {
    options.width /= 2;
    options.height /= 2;
    return options;
}

/// The same with sorted translucent surfaces.
inline render::RenderOptions withSorting(render::RenderOptions options) {
    options.translucency.method = render::Translucency::sorted;
    return options;
}

/// For what no size of the picture changes.
inline render::RenderOptions thumbnailOptions(const depth::Technique& technique) {
    return smallOptions(technique, 96, 54);
}

/// Of all presets.
inline std::vector<depth::Technique> presetTechniques() {
    std::vector<depth::Technique> all;
    for (const depth::NamedTechnique& preset : depth::presets()) {
        all.push_back(preset.technique);
    }
    return all;
}

/// A scene of boxes with one white material, ambient light and the unit box as mesh 0.
inline scene::Scene boxScene() {
    scene::Scene scene;
    scene.name = "boxes";
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    scene.materials.push_back({.name = "white"});
    scene.lights.push_back(
        {.position = glm::dvec3(5.0, 9.0, 7.0), .color = glm::vec3(1.0f), .halfDistance = 20.0});
    return scene;
}

inline void addBox(scene::Scene& scene, const glm::dvec3& position,
                   const glm::mat3& basis = glm::mat3(1.0f)) {
    scene::addInstance(scene, 0, 0, static_cast<std::uint32_t>(scene.instances.size()), position, basis);
}

/// A floor from behind the camera to the horizon, so large, with boxes half sunk into it: both compete for the pixels around.
inline scene::Scene boxesOnAFloor(float size) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, -2.5, 0.0}, glm::mat3(size, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, size));
    for (int i = 0; i < 40; ++i) {
        const double w = 3.0 * std::pow(1.25, i);
        addBox(scene, {0.1 * w * std::sin(i), -2.0, -w}, glm::mat3(static_cast<float>(0.05 * w + 0.5)));
    }
    return scene;
}

} // namespace cdr::render_test
