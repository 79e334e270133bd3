#include "../../../src/examples/depth_only/draw_anchored.h"
#include "../fixture.h"
#include "read_image.h"
#include "read_spirv.h"

#include <cdr/gpu/commands.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::render_test {

namespace {

constexpr vk::Extent2D kExtent{160, 160};
constexpr vk::Format kIds = vk::Format::eR32Uint;
constexpr vk::Format kDepth = vk::Format::eD32Sfloat;
constexpr double kTurn = 0.3; ///< of each square about the view's axis, so that a transposed basis would show

/// The attributes 1 to 4 of the recipe's shaders.
struct Placed {
    std::array<std::array<float, 3>, 3> turnAndScale;
    std::array<float, 3> centre;
};

struct Language {
    const char* vertexShader;
    bool takesRows; ///< of a matrix, one an attribute; else columns
};

/// Draws the recipe's objects as squares, the i-th with id i + 1, by the recipe's own shader.
class DeviceEngine : public adoption::Engine {
  public:
    DeviceEngine(const gpu::Device& device, const Language& language)
        : m_device(device),
          m_takesRows(language.takesRows),
          m_vertices(device, sizeof(kSquare), vk::BufferUsageFlagBits::eVertexBuffer,
                     gpu::MemoryUse::hostWrites, "square"),
          m_placed(device, kMaxDraws * sizeof(Placed), vk::BufferUsageFlagBits::eVertexBuffer,
                   gpu::MemoryUse::hostWrites, "placed"),
          m_ids(device,
                {.extent = kExtent,
                 .format = kIds,
                 .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc},
                "ids"),
          m_depth(device,
                  {.extent = kExtent,
                   .format = kDepth,
                   .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
                   .aspect = vk::ImageAspectFlagBits::eDepth},
                  "depth") {
        constexpr auto kBoth = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
        m_layout = gpu::makePipelineLayout(device, {{}, {{kBoth, 0, 36}}}, "recipe");
        constexpr vk::Format kVec3 = vk::Format::eR32G32B32Sfloat;
        m_pipeline = gpu::makeGraphicsPipeline(
            device, {.name = "recipe",
                     .vertexSpirv = readSpirv(language.vertexShader),
                     .fragmentSpirv = readSpirv(CDR_ID_OF_PUSH),
                     .layout = m_layout,
                     .bindings = {{0, sizeof(kSquare[0]), vk::VertexInputRate::eVertex},
                                  {1, sizeof(Placed), vk::VertexInputRate::eInstance}},
                     .attributes = {{0, 0, kVec3, 0},
                                    {1, 1, kVec3, 0},
                                    {2, 1, kVec3, 12},
                                    {3, 1, kVec3, 24},
                                    {4, 1, kVec3, offsetof(Placed, centre)}},
                     .colorFormats = {kIds},
                     .depthFormat = kDepth});
        std::memcpy(m_vertices.mapped(), kSquare.data(), sizeof(kSquare));
        m_vertices.flush();
    }

    /// Ids by pixel, 0 for background.
    image::Raster<std::uint32_t> show() {
        gpu::runOnce(m_device, [&](vk::CommandBuffer commands) {
            m_commands = commands;
            m_draws = 0;
            cdr::depth::Cascades cascades;
            drawAnchored(*this, cascades);
            commands.endRendering();
            m_cascades = cascades.size();
        });
        return readImage<std::uint32_t>(m_device, m_ids.handle(), kExtent,
                                        VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    }
    std::size_t cascades() const { return m_cascades; }

    void clearDepth(float value) override {
        const bool isFirst = m_draws == 0;
        if (isFirst) {
            enterLayouts();
        } else {
            m_commands.endRendering();
            gpu::pipelineBarrier(
                m_commands, {},
                {{.srcStageMask = vk::PipelineStageFlagBits2::eAllGraphics,
                  .srcAccessMask = vk::AccessFlagBits2::eMemoryWrite,
                  .dstStageMask = vk::PipelineStageFlagBits2::eAllGraphics,
                  .dstAccessMask = vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite}});
        }
        const vk::RenderingAttachmentInfo color{.imageView = m_ids.view(),
                                                .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                                .loadOp = isFirst ? vk::AttachmentLoadOp::eClear
                                                                  : vk::AttachmentLoadOp::eLoad,
                                                .storeOp = vk::AttachmentStoreOp::eStore};
        const vk::RenderingAttachmentInfo depth{.imageView = m_depth.view(),
                                                .imageLayout = vk::ImageLayout::eDepthAttachmentOptimal,
                                                .loadOp = vk::AttachmentLoadOp::eClear,
                                                .storeOp = vk::AttachmentStoreOp::eDontCare,
                                                .clearValue = vk::ClearDepthStencilValue{value, 0}};
        m_commands.beginRendering({.renderArea = {{0, 0}, kExtent},
                                   .layerCount = 1,
                                   .colorAttachmentCount = 1,
                                   .pColorAttachments = &color,
                                   .pDepthAttachment = &depth});
        m_commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *m_pipeline);
        m_commands.setViewport(0, vk::Viewport{.width = float(kExtent.width),
                                               .height = float(kExtent.height),
                                               .minDepth = 0.0f,
                                               .maxDepth = 1.0f});
        m_commands.setScissor(0, vk::Rect2D{{0, 0}, kExtent});
        m_commands.setCullMode(vk::CullModeFlagBits::eNone);
        m_commands.setFrontFace(vk::FrontFace::eCounterClockwise);
        m_commands.bindVertexBuffers(0, {m_vertices.handle(), m_placed.handle()}, {0, 0});
    }

    void setCascade(const cdr::depth::CascadeConstants& constants) override { push(0, constants); }

    void draw(const adoption::Object& object, float x, float y, float ahead) override {
        const auto turned = [&](double angle) { return static_cast<float>(object.radius * angle); };
        const float c = turned(std::cos(kTurn));
        const float s = turned(m_takesRows ? -std::sin(kTurn) : std::sin(kTurn));
        m_placed.as<Placed>(kMaxDraws)[m_draws] = {{{{c, s, 0.0f}, {-s, c, 0.0f}, {0.0f, 0.0f, 1.0f}}},
                                                   {x, y, ahead}};
        m_placed.flush();
        push(sizeof(cdr::depth::CascadeConstants), static_cast<std::uint32_t>(&object - visible.data()) + 1);
        m_commands.draw(static_cast<std::uint32_t>(kSquare.size()), 1, 0, m_draws++);
    }

  private:
    static constexpr std::uint32_t kMaxDraws = 64;
    static constexpr std::array<std::array<float, 3>, 6> kSquare{
        {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};

    template <typename Value>
    void push(std::uint32_t offset, const Value& value) {
        m_commands.pushConstants<Value>(
            *m_layout, vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment, offset, value);
    }

    void enterLayouts() {
        using PipelineStage = vk::PipelineStageFlagBits2;
        using Access = vk::AccessFlagBits2;
        gpu::pipelineBarrier(
            m_commands,
            {gpu::imageBarrier(m_ids.handle(), vk::ImageAspectFlagBits::eColor,
                               {PipelineStage::eNone, Access::eNone, vk::ImageLayout::eUndefined},
                               {PipelineStage::eColorAttachmentOutput, Access::eColorAttachmentWrite,
                                vk::ImageLayout::eColorAttachmentOptimal}),
             gpu::imageBarrier(m_depth.handle(), vk::ImageAspectFlagBits::eDepth,
                               {PipelineStage::eNone, Access::eNone, vk::ImageLayout::eUndefined},
                               {PipelineStage::eAllGraphics, Access::eMemoryRead | Access::eMemoryWrite,
                                vk::ImageLayout::eDepthAttachmentOptimal})});
    }

    const gpu::Device& m_device;
    bool m_takesRows;
    gpu::Buffer m_vertices;
    gpu::Buffer m_placed;
    gpu::Image m_ids;
    gpu::Image m_depth;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
    vk::CommandBuffer m_commands;
    std::uint32_t m_draws = 0;
    std::size_t m_cascades = 0;
};

constexpr int kColumns = 10;
constexpr double kFarView = 1e6;
constexpr double kGap = 1e-5;

/// A view 20 units high, a million units away. In each column two squares lie a gap apart, the first of the list in front in
/// every other one. A square at arm's length covers the middle.
void fill(adoption::Engine& engine) {
    engine.nearView = 0.001;
    engine.farView = 2e6;
    engine.projection = {.fovY = 2.0 * std::atan(10.0 / kFarView), .aspect = 1.0};
    engine.footprintSlope = 20.0 / kFarView / kExtent.height;
    engine.visible = {{{0.0, 0.0, -0.01}, 2e-8}};
    for (int column = 0; column < kColumns; ++column) {
        const double behind = column % 2 == 0 ? kGap : -kGap;
        const double x = -9.0 + 2.0 * column;
        engine.visible.push_back({{x, 6.0, -kFarView - 0.25 * column}, 0.7});
        engine.visible.push_back({{x, 6.0, -kFarView - 0.25 * column - behind}, 0.7});
    }
}

using AdoptionTest = RenderTest;

/// Both halves of the recipe draw what is 0.00001 units nearer, a million units away, whichever is drawn first. And the shader
/// in HLSL draws the picture of that in GLSL.
TEST_F(AdoptionTest, TheRecipeOrdersWhatFloat32DistancesCannot) {
    std::vector<image::Raster<std::uint32_t>> pictures;
    for (const Language& language :
         {Language{CDR_ADOPTION_VERT, false}, Language{CDR_ADOPTION_VERT_HLSL, true}}) {
        DeviceEngine engine(device(), language);
        fill(engine);
        pictures.push_back(engine.show());
        EXPECT_EQ(engine.cascades(), 2u);
        const image::Raster<std::uint32_t>& ids = pictures.back();
        EXPECT_EQ(ids.at(kExtent.width / 2, kExtent.height / 2), 1u);
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const std::uint32_t first = 2 + 2 * column;
            const std::uint32_t x = kExtent.width * (2 * column + 1) / (2 * kColumns);
            for (const std::uint32_t beside : {x - 3, x, x + 3}) {
                EXPECT_EQ(ids.at(beside, kExtent.height / 5), column % 2 == 0 ? first : first + 1)
                    << "column " << column;
            }
        }
    }
    EXPECT_EQ(pictures[0].pixels, pictures[1].pixels);
}

} // namespace

} // namespace cdr::render_test
