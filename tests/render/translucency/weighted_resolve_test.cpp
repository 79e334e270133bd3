#include "../fixture.h"

#include <cdr/gpu/commands.h>
#include <cdr/gpu/upload.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/translucency.h>

#include <glm/gtc/packing.hpp>

#include <array>
#include <limits>

namespace cdr::render_test {

namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr vk::Extent2D kThreePixels{3, 1};

class WeightedResolveTest : public RenderTest {
  protected:
    gpu::Image sumOf(vk::Format format, std::initializer_list<float> values) {
        std::vector<std::uint16_t> halves;
        for (const float value : values) {
            halves.push_back(glm::packHalf1x16(value));
        }
        const std::span<const std::byte> bytes = std::as_bytes(std::span(halves));
        return gpu::uploadImage(device(), kThreePixels, format, {&bytes, 1}, "sums");
    }

    /// What the pixels are resolved to, over black.
    std::array<glm::vec4, 3> resolved(const gpu::Image& sum, const gpu::Image& weight) {
        constexpr auto kImage = vk::DescriptorType::eCombinedImageSampler;
        const render::FullscreenPass pass(device(), {.name = "weighted resolve",
                                                     .fragmentSpirv = kTranslucentWeightedResolveFrag,
                                                     .bindings = {kImage, kImage},
                                                     .format = render::kLitFormat,
                                                     .blend = gpu::Blend::over});
        const render::PassInputs inputs = pass.makeInputs();
        inputs.setImage(0, sum);
        inputs.setImage(1, weight);
        const gpu::Image lit(device(), render::colorOptions(kThreePixels, render::kLitFormat), "lit");
        std::array<glm::vec4, 3> colors{};
        const gpu::Buffer copy(device(), colors.size() * sizeof(std::uint64_t),
                               vk::BufferUsageFlagBits::eTransferDst, gpu::MemoryUse::hostReads, "copy");
        gpu::runOnce(device(), [&](vk::CommandBuffer commands) {
            gpu::pipelineBarrier(commands, {render::attachBarrier(lit)});
            const render::FullscreenPass::Draw draw{.set = *inputs};
            pass.record(commands, {&draw, 1}, {.into = lit, .load = vk::AttachmentLoadOp::eClear});
            gpu::pipelineBarrier(commands, {render::copyBarrier(lit, render::kDrawnColor)});
            commands.copyImageToBuffer(
                lit.handle(), vk::ImageLayout::eTransferSrcOptimal, copy.handle(),
                vk::BufferImageCopy{.imageSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
                                    .imageExtent = {kThreePixels.width, kThreePixels.height, 1}});
        });
        copy.invalidate();
        std::ranges::transform(copy.as<std::uint64_t>(colors.size()), colors.begin(),
                               [](std::uint64_t pixel) { return glm::unpackHalf4x16(pixel); });
        return colors;
    }
};

/// Drivers round sums beyond the largest half float to infinity, lavapipe to that number, and SwiftShader to none.
TEST_F(WeightedResolveTest, SumsBeyondHalfFloatsAreTheLargestOne) {
    const gpu::Image sum = sumOf(vk::Format::eR16G16B16A16Sfloat, {kInfinite, kInfinite, 100.0f, 0.0f, //
                                                                   kInfinite, 4096.0f, 2048.0f, 0.0f,  //
                                                                   kNoNumber, kNoNumber, kNoNumber, 0.0f});
    const gpu::Image weight = sumOf(vk::Format::eR16Sfloat, {kInfinite, 2047.0f, kNoNumber});
    const std::array<glm::vec4, 3> colors = resolved(sum, weight);
    EXPECT_EQ(colors[0].r, 1.0f); // many layers of light 1
    EXPECT_EQ(colors[0].g, 1.0f);
    EXPECT_NEAR(colors[0].b, 100.0 / 65504.0, 1e-5);
    EXPECT_EQ(colors[1].r, 32.0f); // a few of more light
    EXPECT_NEAR(colors[1].g, 4096.0 / 2047.0, 2e-3);
    EXPECT_NEAR(colors[1].b, 2048.0 / 2047.0, 1e-3);
    EXPECT_EQ(colors[2].r, 1.0f);
    EXPECT_EQ(colors[2].b, 1.0f);
}

} // namespace

} // namespace cdr::render_test
