#include "../support/refusal.h"
#include "../support/shared_device.h"

#include <cdr/base/error.h>
#include <cdr/render/part_scene.h>
#include <cdr/render/renderer.h>
#include <scenes/cubes.h>
#include <scenes/mixed.h>

#include <gtest/gtest.h>
#include <program/sha256.h>
#include <runs/part_frames.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace cdr::runs {
namespace {

class PartFrames : public test::DeviceTest {
  protected:
    render::Frame draw(const scene::Scene& scene, const scene::Camera& camera,
                       const render::RenderOptions& options) {
        const render::GpuScene onDevice(device(), scene);
        return render::Renderer(device(), scene, onDevice, options).render(camera);
    }

    static void expectOwnCascades(const render::Frame& frame, const render::CascadePart& part) {
        const platform::IndexRange own = part.of(frame.cascades.size());
        EXPECT_TRUE(std::ranges::all_of(frame.gbuffer.pixels, [&](const render::GBufferPixel& pixel) {
            return pixel.id() == 0 || (pixel.cascade() >= own.begin && pixel.cascade() < own.end);
        }));
    }

    /// Draws all parts, from the farthest on, each with its own share of the scene.
    render::Frame drawInParts(const scene::Scene& scene, const scene::Camera& camera,
                              render::RenderOptions options, std::size_t parts) {
        platform::WorkerPool workers(1);
        platform::Bytes farther;
        render::Frame frame;
        for (std::size_t part = parts; part-- > 0;) {
            options.part = {.index = part, .count = parts};
            scene::Scene own = scene;
            dropOtherParts(own, options, {&camera, 1}, workers);
            frame = draw(own, camera, options);
            expectOwnCascades(frame, options.part);
            layUnder(frame, farther);
            farther = packedSurfaces(frame);
        }
        return frame;
    }
};

std::string pixelsOf(const render::Frame& frame) {
    return program::sha256Of(frame.color.pixels) + program::sha256Of(frame.gbuffer.pixels);
}

render::RenderOptions optionsFor(const std::string& split, depth::Mapping mapping) {
    return {.width = 320,
            .height = 180,
            .technique = {mapping, depth::parseSplit(split), depth::DepthFormat::d32f}};
}

/// To the bit, whatever brings cascades to the G-buffer and whether there are more parts or more cascades.
TEST_F(PartFrames, LaidOverEachOtherAreTheWholeFrame) {
    const scene::SceneSetup setup = scenes::makeMixed();
    const scene::Camera camera = setup.path.at(0);
    for (const auto mapping :
         {depth::Mapping::standard, depth::Mapping::anchored, depth::Mapping::anchoredReversed}) {
        for (const char* targets : {"single", "accumulate", "pool:2", "layers", "one-pass"}) {
            render::RenderOptions options = optionsFor("count:5", mapping);
            options.targets = render::parseTargets(targets);
            const render::Frame whole = draw(setup.scene, camera, options);
            for (const std::size_t parts : {2u, 3u, 8u}) {
                const render::Frame merged = drawInParts(setup.scene, camera, options, parts);
                const std::string where = std::string(targets) + " " + std::to_string(parts);
                EXPECT_EQ(pixelsOf(merged), pixelsOf(whole)) << where;
                EXPECT_EQ(merged.stats.draws, whole.stats.draws) << where;
                EXPECT_EQ(merged.stats.visible, whole.stats.visible) << where;
                EXPECT_EQ(merged.anchorsView, whole.anchorsView) << where;
            }
        }
    }
}

/// A fitted split sees all instances, though a part holds few meshes.
TEST_F(PartFrames, CutFittedCascadesAlike) {
    const scene::SceneSetup setup = scenes::makeAfcNear(2013);
    const scene::Camera camera = setup.path.at(7);
    for (const auto surface : {render::SurfacePath::gbuffer, render::SurfacePath::visibility}) {
        render::RenderOptions options = optionsFor("fitted", depth::Mapping::anchored);
        options.surface = surface;
        const render::Frame whole = draw(setup.scene, camera, options);
        ASSERT_GE(whole.cascades.size(), 2u);
        for (const std::size_t parts : {2u, 4u}) {
            EXPECT_EQ(pixelsOf(drawInParts(setup.scene, camera, options, parts)), pixelsOf(whole)) << parts;
        }
    }
}

TEST_F(PartFrames, OfDifferentMeshesHoldFewerTriangles) {
    scene::Scene scene;
    scene.materials.emplace_back();
    for (std::uint32_t i = 0; i < 4; ++i) {
        scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
        scene.textures.push_back({.pixels = image::ImageRgba8(8, 8, {200, 100, 50, 255})});
        scene.materials.push_back({.baseColorTexture = i});
        scene::addInstance(scene, i, i + 1, i, {0.0, 0.0, -5.0 * std::pow(10.0, i)}, glm::mat3(1.0f));
    }
    const scene::Camera camera =
        scene::lookAt({.fovY = 0.8, .nearView = 1.0, .farView = 1e4}, {0.0, 0.0, 0.0}, {0.0, 0.0, -1.0});
    platform::WorkerPool workers(1);
    render::RenderOptions options = optionsFor("count:4", depth::Mapping::anchored);
    for (std::size_t part = 0; part < 2; ++part) {
        options.part = {.index = part, .count = 2};
        scene::Scene own = scene;
        for (scene::Mesh& mesh : own.meshes) {
            mesh.clusters.indices = mesh.indices;
        }
        dropOtherParts(own, options, {&camera, 1}, workers);
        for (std::size_t i = 0; i < 4; ++i) {
            const bool isOwn = i / 2 == part;
            EXPECT_EQ(own.meshes[i].indices.empty(), !isOwn) << i;
            EXPECT_EQ(own.meshes[i].clusters.indices.empty(), !isOwn) << i;
            EXPECT_EQ(own.meshes[i].vertices.capacity() == 0, !isOwn) << i;
            EXPECT_EQ(own.meshes[i].indices.capacity() == 0, !isOwn) << i;
            EXPECT_EQ(own.textures[i].pixels.width, isOwn ? 8u : 1u) << i;
            EXPECT_EQ(own.meshes[i].boundingRadius, scene.meshes[i].boundingRadius);
        }
    }
    options.part = {};
    EXPECT_EQ(pixelsOf(drawInParts(scene, camera, options, 4)), pixelsOf(draw(scene, camera, options)));
}

TEST_F(PartFrames, AreRefusedWhereAPixelNeedsMoreThanItsSurface) {
    const scene::SceneSetup setup = scenes::makeRotation(3, 10);
    const render::GpuScene onDevice(device(), setup.scene);
    const auto refusalOf = [&](render::RenderOptions options) -> std::string {
        options.part = {.index = 1, .count = 2};
        return test::inputErrorOf(
            [&] { const render::Renderer renderer(device(), setup.scene, onDevice, options); });
    };
    const render::RenderOptions good = optionsFor("count:2", depth::Mapping::standard);
    EXPECT_EQ(refusalOf(good), "");
    const auto changed = [&](const auto& change) {
        render::RenderOptions options = good;
        change(options);
        return refusalOf(options);
    };
    const std::string all = "cascades cannot be divided: ";
    const std::string need = " need all of them";
    EXPECT_EQ(changed([](auto& options) { options.effects.antialias = render::Antialias::edges; }),
              all + "smoothed edges" + need);
    EXPECT_EQ(changed([](auto& options) { options.effects.occlusion.radius = 1.0; }),
              all + "ambient occlusion over the whole picture" + need);
    EXPECT_EQ(changed([](auto& options) { options.shadows.method = render::ShadowMethod::plain; }),
              all + "shadows" + need);
    EXPECT_EQ(changed([](auto& options) { options.motion = true; }), all + "motion" + need);
    EXPECT_EQ(changed([](auto& options) { options.linear = true; }), all + "pictures of linear light" + need);
    EXPECT_EQ(changed([](auto& options) { options.submission = render::Submission::gpuDriven; }),
              all + "gpu-driven draws" + need);
    EXPECT_EQ(changed([](auto& options) {
                  options.effects.occlusion = {.radius = 1.0, .perLayer = true};
                  options.targets = render::TargetsKind::layers;
              }),
              "");
    render::RenderOptions beyond = good;
    beyond.part = {.index = 2, .count = 2};
    EXPECT_THROW(requireDivisible(beyond, {}), base::InputError);
    EXPECT_THROW(requireDivisible(good, {.blended = true}), base::InputError);
}

TEST_F(PartFrames, RefuseBytesOfAnotherSize) {
    const scene::SceneSetup setup = scenes::makeMixed();
    const render::RenderOptions options = optionsFor("none", depth::Mapping::standard);
    const render::Frame frame = draw(setup.scene, setup.path.at(0), options);
    const platform::Bytes packed = packedSurfaces(frame);
    const auto shown = static_cast<std::size_t>(std::ranges::count_if(
        frame.gbuffer.pixels, [](const render::GBufferPixel& pixel) { return pixel.id() != 0; }));
    ASSERT_GT(shown, 0u);
    EXPECT_LT(packed.size(), shown * 20 + frame.gbuffer.pixels.size());
    render::Frame same = frame;
    EXPECT_THROW(layUnder(same, {packed.begin(), packed.end() - 1}), base::RunError);
    render::Frame smaller;
    smaller.gbuffer = image::Raster<render::GBufferPixel>(10, 10);
    smaller.color = image::ImageRgba8(10, 10);
    EXPECT_THROW(layUnder(smaller, packed), base::RunError);
    render::Frame empty = frame;
    empty.gbuffer = image::Raster<render::GBufferPixel>(320, 180);
    layUnder(empty, packed);
    EXPECT_EQ(pixelsOf(empty), pixelsOf(frame));
}

} // namespace
} // namespace cdr::runs
