#include "../fixture.h"
#include "../host/read_image.h"

#include <cdr/gpu/commands.h>
#include <cdr/render/shadows/seen_slices.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <scenes/open_scene.h>

#include <array>
#include <cstdint>
#include <vector>

namespace cdr::render_test {

namespace {

using render::SeenSlices;
using render::SlicePixels;

constexpr vk::Extent2D kExtent{64, 32};
constexpr vk::Rect2D kWhole{{0, 0}, kExtent};

/// On a device that skips what depends on a buffer.
class SeenSlicesTest : public RenderTest {
  protected:
    void SetUp() override {
        if (!device().info().hasConditionalRendering) {
            GTEST_SKIP() << device().info().name << " has no VK_EXT_conditional_rendering";
        }
    }

    /// Slice by slice, whether what is recorded for it is drawn where pixels of the picture have these depths.
    std::vector<bool> drawnOf(const std::vector<SlicePixels>& picture,
                              const std::vector<SlicePixels>& slices) {
        const gpu::Image depth(device(),
                               {.extent = kExtent,
                                .format = render::SliceDepth::kFormat,
                                .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
                                .aspect = vk::ImageAspectFlagBits::eDepth},
                               "slices of a test");
        const gpu::Image marks(
            device(),
            {.extent = kExtent,
             .format = vk::Format::eR8Unorm,
             .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc},
            "marks of a test");
        const SeenSlices seen(device());
        const SeenSlices::Slot slot = seen.makeSlot();
        gpu::runOnce(device(), [&](vk::CommandBuffer commands) {
            fill(commands, depth, picture);
            seen.record(commands, slot, slices, depth);
            mark(commands, marks, slot, slices.size());
        });
        const auto read =
            readImage<std::uint8_t>(device(), marks.handle(), kExtent,
                                    static_cast<VkImageLayout>(vk::ImageLayout::eColorAttachmentOptimal));
        std::vector<bool> drawn;
        for (std::size_t i = 0; i < slices.size(); ++i) {
            drawn.push_back(read.pixels[i] != 0);
        }
        return drawn;
    }

  private:
    static void fill(vk::CommandBuffer commands, const gpu::Image& depth,
                     const std::vector<SlicePixels>& picture) {
        using render::Access;
        gpu::pipelineBarrier(
            commands, {gpu::imageBarrier(depth.handle(), vk::ImageAspectFlagBits::eDepth,
                                         {render::kDepthStages, Access::eNone, vk::ImageLayout::eUndefined},
                                         {render::kDepthStages, render::kDepthAccess,
                                          vk::ImageLayout::eAttachmentOptimal})});
        const vk::RenderingAttachmentInfo attachment{.imageView = depth.view(),
                                                     .imageLayout = vk::ImageLayout::eAttachmentOptimal,
                                                     .loadOp = vk::AttachmentLoadOp::eClear,
                                                     .storeOp = vk::AttachmentStoreOp::eStore};
        commands.beginRendering({.renderArea = kWhole, .layerCount = 1, .pDepthAttachment = &attachment});
        for (const SlicePixels& part : picture) {
            commands.clearAttachments(
                vk::ClearAttachment{.aspectMask = vk::ImageAspectFlagBits::eDepth,
                                    .clearValue = vk::ClearDepthStencilValue{.depth = part.depth}},
                vk::ClearRect{.rect = part.area, .layerCount = 1});
        }
        commands.endRendering();
        gpu::pipelineBarrier(commands,
                             {gpu::imageBarrier(depth.handle(), vk::ImageAspectFlagBits::eDepth,
                                                {render::kDepthStages, Access::eDepthStencilAttachmentWrite,
                                                 vk::ImageLayout::eAttachmentOptimal},
                                                {render::kDepthStages, Access::eDepthStencilAttachmentRead,
                                                 vk::ImageLayout::eAttachmentOptimal})});
    }

    /// Pixel i of the first row, if commands of slice i are not skipped.
    static void mark(vk::CommandBuffer commands, const gpu::Image& marks, const SeenSlices::Slot& slot,
                     std::size_t slices) {
        gpu::pipelineBarrier(commands, {render::attachBarrier(marks)});
        const auto attachment = render::colorAttachment(marks.view(), vk::AttachmentLoadOp::eClear);
        commands.beginRendering({.renderArea = kWhole,
                                 .layerCount = 1,
                                 .colorAttachmentCount = 1,
                                 .pColorAttachments = &attachment});
        for (std::size_t i = 0; i < slices; ++i) {
            SeenSlices::begin(commands, slot, i);
            commands.clearAttachments(
                vk::ClearAttachment{.aspectMask = vk::ImageAspectFlagBits::eColor,
                                    .clearValue = vk::ClearColorValue{std::array{1.0f, 0.0f, 0.0f, 0.0f}}},
                vk::ClearRect{.rect = {{static_cast<std::int32_t>(i), 0}, {1, 1}}, .layerCount = 1});
            SeenSlices::end(commands);
        }
        commands.endRendering();
    }
};

float depthOf(int slice) {
    return static_cast<float>(slice) / shaders::kMaxSlices;
}

TEST_F(SeenSlicesTest, CommandsOfASliceWithoutAPixelAreSkipped) {
    const vk::Rect2D left{{0, 0}, {32, 32}};
    const vk::Rect2D onePixel{{40, 20}, {1, 1}};
    const std::vector<SlicePixels> picture{{depthOf(100), left}, {depthOf(102), onePixel}};
    EXPECT_EQ(drawnOf(picture, {{depthOf(99), kWhole},
                                {depthOf(100), kWhole},
                                {depthOf(101), kWhole},
                                {depthOf(102), kWhole},
                                {depthOf(103), kWhole}}),
              (std::vector{false, true, false, true, false}));
    // Beside its area a slice has none.
    EXPECT_EQ(drawnOf(picture, {{depthOf(102), left}, {depthOf(102), onePixel}, {depthOf(100), onePixel}}),
              (std::vector{false, true, false}));
    EXPECT_TRUE(drawnOf(picture, {}).empty());
}

/// Of frames in which most slices are without a pixel.
TEST_F(SeenSlicesTest, PicturesAreThoseOfADeviceThatSkipsNothing) {
    const gpu::Device plain(lentDevice());
    ASSERT_FALSE(plain.info().hasConditionalRendering);
    for (const char* name : {"orbit", "rotation"}) {
        const scene::SceneSetup setup = scenes::openScene(name, scenes::kDefaultSeed).setup;
        const render::GpuScene ownScene(device(), setup.scene);
        const render::GpuScene plainScene(plain, setup.scene);
        for (const render::ShadowMethod method :
             {render::ShadowMethod::anchored, render::ShadowMethod::plain}) {
            render::RenderOptions options = thumbnailOptions(depth::namedTechnique("anchored").technique);
            options.shadows.method = method;
            options.shadows.maxTexels = render::kMinShadowTexels;
            options.framesInFlight = 2;
            render::Renderer own(device(), setup.scene, ownScene, options);
            render::Renderer all(plain, setup.scene, plainScene, options);
            for (const std::uint32_t frame : {0u, 60u}) {
                const scene::Camera camera = setup.path.at(frame);
                const render::Frame skipping = own.render(camera);
                const render::Frame whole = all.render(camera);
                EXPECT_EQ(hashOf(skipping), hashOf(whole)) << name << " frame " << frame;
                EXPECT_EQ(skipping.litMask.pixels, whole.litMask.pixels) << name << " frame " << frame;
            }
        }
    }
}

} // namespace

} // namespace cdr::render_test
