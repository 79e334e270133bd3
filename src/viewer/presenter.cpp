#include "presenter.h"

#include "window_capture.h"

#include <imgui.h>
#include <imgui_impl_vulkan.h>

#include <algorithm>
#include <limits>

namespace cdr::viewer {

namespace {

/// Behind pictures and interface.
constexpr vk::ClearColorValue kBackground(std::array{0.066f, 0.071f, 0.082f, 1.0f});
constexpr vk::ImageSubresourceRange kWhole{vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1};

/// The part of an area that an image has: the surface may have shrunk since the area was laid out.
vk::Rect2D within(const vk::Rect2D& area, vk::Extent2D extent) {
    const auto x = static_cast<std::uint32_t>(std::max(area.offset.x, 0));
    const auto y = static_cast<std::uint32_t>(std::max(area.offset.y, 0));
    if (x >= extent.width || y >= extent.height) {
        return {};
    }
    return {area.offset,
            {std::min(area.extent.width, extent.width - x), std::min(area.extent.height, extent.height - y)}};
}

} // namespace

Presenter::Presenter(const UiDevice& ui, const Window& window, bool waitsForDisplay)
    : m_ui(ui),
      m_device(ui.device()),
      m_window(window),
      m_waitsForDisplay(waitsForDisplay),
      m_pictures{std::make_unique<PictureTexture>(m_device, kFramesInFlight, "left picture"),
                 std::make_unique<PictureTexture>(m_device, kFramesInFlight, "right picture")} {
    for (Slot& slot : m_slots) {
        slot.pool =
            std::make_unique<gpu::CommandPool>(m_device, vk::CommandBufferLevel::ePrimary, "interface");
        slot.done = m_device.handle().createFenceUnique({.flags = vk::FenceCreateFlagBits::eSignaled});
        slot.imageReady = m_device.handle().createSemaphoreUnique({});
    }
    renew();
}

Presenter::~Presenter() {
    try {
        m_device.handle().waitIdle();
    } catch (const vk::Error&) {
        // Reported where somebody waits for a frame.
    }
}

void Presenter::renew() {
    m_device.handle().waitIdle();
    m_wanted = m_window.extent();
    m_swapchain =
        std::make_unique<Swapchain>(m_device, m_ui.surface(), m_wanted, m_waitsForDisplay, m_swapchain.get());
    m_isStale = false;
}

bool Presenter::draw(const PictureLayout& layout, ImDrawData* interface, image::ImageRgba8* capture) {
    const vk::Extent2D wanted = m_window.extent();
    if (wanted.width == 0 || wanted.height == 0) {
        return false;
    }
    if (m_isStale || m_wanted != wanted) {
        renew();
    }
    const std::size_t index = m_frames % kFramesInFlight;
    Slot& slot = m_slots[index];
    const vk::Result waited =
        m_device.handle().waitForFences(*slot.done, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
    vk::resultCheck(waited, "vkWaitForFences");
    const std::optional<std::uint32_t> image = m_swapchain->acquire(*slot.imageReady);
    if (!image) {
        m_isStale = true;
        return false;
    }
    ++m_frames;
    m_device.handle().resetFences(*slot.done);
    slot.pool->reset();
    const Swapchain::Image& target = m_swapchain->image(*image);
    std::optional<WindowCapture> reader;
    if (capture != nullptr) {
        reader.emplace(m_device, *m_swapchain);
    }
    if (layout.pictures < m_pictures.size()) {
        m_pictures.back()->forget();
    }
    const vk::CommandBuffer commands = slot.pool->next();
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record(commands, index, target, layout, interface);
    if (reader) {
        reader->record(commands, target.image);
    }
    commands.end();
    submit(commands, slot, target);
    m_isStale = !m_swapchain->present(m_device.queue(), *image);
    if (reader) {
        m_device.handle().waitIdle();
        *capture = reader->fetch();
    }
    return true;
}

void Presenter::record(vk::CommandBuffer commands, std::size_t slot, const Swapchain::Image& target,
                       const PictureLayout& layout, ImDrawData* interface) {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    for (const auto& picture : m_pictures) {
        picture->recordUpload(commands, slot);
    }
    gpu::pipelineBarrier(
        commands, {gpu::imageBarrier(target.image, vk::ImageAspectFlagBits::eColor, Stage::eAllTransfer,
                                     Access::eNone, Stage::eAllTransfer, Access::eTransferWrite,
                                     vk::ImageLayout::eUndefined, vk::ImageLayout::eTransferDstOptimal)});
    commands.clearColorImage(target.image, vk::ImageLayout::eTransferDstOptimal, kBackground, kWhole);
    gpu::pipelineBarrier(
        commands,
        {gpu::imageBarrier(target.image, vk::ImageAspectFlagBits::eColor, Stage::eAllTransfer,
                           Access::eTransferWrite, Stage::eAllTransfer, Access::eTransferWrite,
                           vk::ImageLayout::eTransferDstOptimal, vk::ImageLayout::eTransferDstOptimal)});
    const vk::Rect2D area = within(layout.area, m_swapchain->extent());
    const double divider = layout.pictures > 1 ? layout.divider : 1.0;
    m_pictures[0]->recordBlit(commands, target.image, area, 0.0, divider);
    m_pictures[1]->recordBlit(commands, target.image, area, divider, 1.0);
    commands.beginRenderPass({.renderPass = m_swapchain->renderPass(),
                              .framebuffer = *target.framebuffer,
                              .renderArea = {{0, 0}, m_swapchain->extent()}},
                             vk::SubpassContents::eInline);
    ImGui_ImplVulkan_RenderDrawData(interface, commands);
    commands.endRenderPass();
}

void Presenter::submit(vk::CommandBuffer commands, const Slot& slot, const Swapchain::Image& target) const {
    const vk::SemaphoreSubmitInfo wait{.semaphore = *slot.imageReady,
                                       .stageMask = vk::PipelineStageFlagBits2::eAllTransfer};
    const vk::SemaphoreSubmitInfo signal{.semaphore = *target.drawn,
                                         .stageMask = vk::PipelineStageFlagBits2::eAllCommands};
    const vk::CommandBufferSubmitInfo buffer{.commandBuffer = commands};
    m_device.queue().submit2(vk::SubmitInfo2{.waitSemaphoreInfoCount = 1,
                                             .pWaitSemaphoreInfos = &wait,
                                             .commandBufferInfoCount = 1,
                                             .pCommandBufferInfos = &buffer,
                                             .signalSemaphoreInfoCount = 1,
                                             .pSignalSemaphoreInfos = &signal},
                             *slot.done);
}

} // namespace cdr::viewer
