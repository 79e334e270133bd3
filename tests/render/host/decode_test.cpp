#include "../fixture.h"
#include "host_side.h"
#include "read_spirv.h"

#include <cdr/gpu/pipeline.h>
#include <cdr/scene/world/world.h>
#include <scenes/cubes.h>

#include <array>
#include <cstring>
#include <functional>
#include <vector>

namespace cdr::render_test {

namespace {

/// Of each pixel: the distance as a pair, id, cascade; normal, whether it is written alike; albedo, whether it is.
using Decoded = std::array<float, 12>;

class DecodeTest : public RenderTest {
  protected:
    using Recorder = std::function<void(vk::CommandBuffer)>;

    /// @param run has commands recorded, and waits until they have run.
    image::Raster<Decoded> decode(const char* shader, const render::SurfaceImage& gbuffer,
                                  const std::vector<double>& anchorsView,
                                  const std::function<void(const Recorder&)>& run) {
        using Type = vk::DescriptorType;
        const std::vector<Type> bindings{Type::eSampledImage, Type::eStorageBuffer};
        constexpr auto kStage = vk::ShaderStageFlagBits::eCompute;
        std::array<std::array<float, 4>, 8> anchors{};
        for (std::size_t i = 0; i < anchorsView.size(); ++i) {
            anchors[i][0] = static_cast<float>(anchorsView[i]);
            anchors[i][1] = static_cast<float>(anchorsView[i] - static_cast<double>(anchors[i][0]));
        }
        const auto setLayout = gpu::makeSetLayout(device(), {bindings, kStage}, "decode");
        const auto layout = gpu::makePipelineLayout(
            device(), {{setLayout}, {{.stageFlags = kStage, .size = sizeof(anchors)}}}, "decode");
        const auto pipeline = gpu::makeComputePipeline(device(), {"decode", readSpirv(shader), layout});
        const gpu::DescriptorSet set(device(), setLayout);
        image::Raster<Decoded> decoded(gbuffer.extent.width, gbuffer.extent.height);
        const gpu::Buffer values(device(), decoded.pixels.size() * sizeof(Decoded),
                                 vk::BufferUsageFlagBits::eStorageBuffer, gpu::MemoryUse::hostReads,
                                 "decoded");
        set.setImage(0, gbuffer.view, {});
        set.setBuffer(1, values);
        run([&](vk::CommandBuffer commands) {
            commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
            commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout, 0, *set, {});
            commands.pushConstants<decltype(anchors)>(*layout, kStage, 0, anchors);
            commands.dispatch((decoded.width + 7) / 8, (decoded.height + 7) / 8, 1);
            gpu::pipelineBarrier(commands, {},
                                 {{.srcStageMask = vk::PipelineStageFlagBits2::eComputeShader,
                                   .srcAccessMask = vk::AccessFlagBits2::eShaderStorageWrite,
                                   .dstStageMask = vk::PipelineStageFlagBits2::eHost,
                                   .dstAccessMask = vk::AccessFlagBits2::eHostRead}});
        });
        values.invalidate();
        std::memcpy(decoded.pixels.data(), values.mapped(), decoded.pixels.size() * sizeof(Decoded));
        return decoded;
    }
};

/// A host's shaders read what Frame says, in GLSL and in HLSL; distances to the same bits.
TEST_F(DecodeTest, AHostsShadersReadWhatAFrameHolds) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const scene::Camera camera = setup.path.at(7);
    SoleRenderer renderer(device(), setup.scene, smallOptions(depth::parseTechnique("anchored/count:4")));
    const render::Frame frame = renderer.render(camera);
    renderer.submit(camera); // leaves the G-buffer for shaders to read
    renderer.finish();
    const render::Surfaces surfaces = renderer.surfaces();
    ASSERT_LE(surfaces.anchorsView.size(), 8u);
    ASSERT_GT(surfaces.anchorsView.size(), 1u);
    const auto runOnce = [&](const Recorder& record) { gpu::runOnce(device(), record); };
    const auto decoded = decode(CDR_DECODE_GBUFFER, surfaces.gbuffer, surfaces.anchorsView, runOnce);
    std::size_t compared = 0;
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 0; x < frame.width(); ++x) {
            const Decoded& pixel = decoded.at(x, y);
            ASSERT_EQ(pixel[2], static_cast<float>(frame.id(x, y)));
            if (frame.id(x, y) == 0) {
                continue;
            }
            ++compared;
            const double distanceView = frame.distanceView(x, y);
            ASSERT_NEAR(static_cast<double>(pixel[0]) + static_cast<double>(pixel[1]), distanceView,
                        1e-13 * distanceView);
            ASSERT_EQ(pixel[3], static_cast<float>(frame.cascade(x, y)));
            const glm::vec3 normal = frame.normalView(x, y);
            ASSERT_LT(glm::distance(glm::vec3(pixel[4], pixel[5], pixel[6]), normal), 1e-6f);
            ASSERT_EQ(pixel[7], 1.0f);
            const std::uint32_t red = frame.gbuffer.at(x, y).albedo & 0xffu;
            const float root = static_cast<float>(red) / 255.0f;
            ASSERT_NEAR(pixel[8], root * root, 1e-6f);
            ASSERT_EQ(pixel[11], 1.0f);
        }
    }
    EXPECT_GT(compared, 1000u);
    const auto byHlsl = decode(CDR_DECODE_GBUFFER_HLSL, surfaces.gbuffer, surfaces.anchorsView, runOnce);
    for (std::size_t i = 0; i < decoded.pixels.size(); ++i) {
        if (decoded.pixels[i][2] != 0.0f) {
            for (std::size_t k = 0; k < 4; ++k) { // what is not a rounded direction or colour
                ASSERT_EQ(byHlsl.pixels[i][k], decoded.pixels[i][k]) << i;
            }
            for (std::size_t k = 4; k < 12; ++k) {
                ASSERT_NEAR(byHlsl.pixels[i][k], decoded.pixels[i][k], 1e-6f) << i;
            }
        }
    }
}

/// A compute shader reads a frame's G-buffer, and the next frame follows in the same command buffer. So the validation layer
/// sees both.
TEST_F(DecodeTest, AFrameWaitsForWhatAHostReadsInAnyStage) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    options.framesInFlight = 2;
    HostSide host(device(), {options.width, options.height});
    SoleRenderer renderer(device(), setup.scene, options);
    const render::Frame wanted = renderer.render(setup.path.at(7));
    const render::HostFrame frame = host.begin();
    renderer.record(setup.path.at(7), frame);
    const render::Surfaces surfaces = renderer.surfaces();
    const auto readAndDrawOn = [&](const Recorder& read) {
        gpu::pipelineBarrier(frame.commands, {},
                             {{.srcStageMask = vk::PipelineStageFlagBits2::eAllCommands,
                               .srcAccessMask = vk::AccessFlagBits2::eMemoryWrite,
                               .dstStageMask = vk::PipelineStageFlagBits2::eComputeShader,
                               .dstAccessMask = vk::AccessFlagBits2::eShaderSampledRead}});
        read(frame.commands);
        host.submit(renderer, setup.path.at(200), frame);
        renderer.finish();
    };
    const auto decoded = decode(CDR_DECODE_GBUFFER, surfaces.gbuffer, surfaces.anchorsView, readAndDrawOn);
    for (std::size_t i = 0; i < decoded.pixels.size(); ++i) {
        ASSERT_EQ(decoded.pixels[i][2], static_cast<float>(wanted.gbuffer.pixels[i].id())) << i;
    }
}

/// Of a box that was behind the last camera, and of the background, in images whose floats hold less than CDR_NO_MOTION too.
TEST_F(DecodeTest, HalfFloatsKeepThatASurfaceHasNoMotion) {
    for (const vk::Format format : {vk::Format::eR32G32Sfloat, vk::Format::eR16G16Sfloat}) {
        scene::World world(boxScene());
        const auto box = world.addInstance(
            {.mesh = world.mesh(0), .material = world.material(0), .transform = {{0.0, 0.0, 4.0}}});
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.motion = true;
        SoleRenderer renderer(device(), world, options);
        renderer.render({.fovY = 0.5});
        world.setTransform(box, {{0.0, 0.0, -4.0}});
        const vk::Extent2D extent{options.width, options.height};
        const gpu::Image into(
            device(),
            {.extent = extent,
             .format = format,
             .usage = vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eSampled},
            "host motion");
        const render::SurfaceImage motion{.image = into.handle(),
                                          .view = into.view(),
                                          .format = static_cast<VkFormat>(format),
                                          .extent = extent,
                                          .layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        HostSide host(device(), extent);
        render::HostFrame frame = host.begin();
        frame.motion = motion;
        host.submit(renderer, {.fovY = 0.5}, frame);
        renderer.finish();
        const auto decoded = decode(CDR_DECODE_MOTION, motion, {},
                                    [&](const Recorder& record) { gpu::runOnce(device(), record); });
        EXPECT_EQ(decoded.at(48, 27)[0], 0.0f) << vk::to_string(format); // cdrHasMotion()
        EXPECT_EQ(decoded.at(0, 0)[0], 1.0f) << vk::to_string(format);
    }
}

} // namespace

} // namespace cdr::render_test
