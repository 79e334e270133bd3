#include "presenter.h"

#include "window_capture.h"

#include <cdr/base/error.h>
#include <viewer/state/surface_choice.h>

#include <imgui.h>
#include <imgui_impl_vulkan.h>

#include <algorithm>
#include <limits>

namespace cdr::viewer {

namespace {

/// Behind pictures and interface.
constexpr vk::ClearColorValue kBackground(std::array{0.066f, 0.071f, 0.082f, 1.0f});
constexpr vk::ImageSubresourceRange kWhole{vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1};

} // namespace

Presenter::Presenter(UiDevice& ui, const Window& window, Pace pace)
    : m_ui(ui),
      m_device(ui.device()),
      m_window(window),
      m_pace(pace),
      m_pictures{std::make_unique<PictureTexture>(m_device, kFramesInFlight, "left picture"),
                 std::make_unique<PictureTexture>(m_device, kFramesInFlight, "right picture")},
      m_format(
          chooseSurfaceFormat(vk::PhysicalDevice(m_device.physical()).getSurfaceFormatsKHR(ui.surface()))),
      m_renderPass(makeWindowPass(m_device.handle(), m_format.format)) {
    for (Slot& slot : m_slots) {
        slot.pool =
            std::make_unique<gpu::CommandPool>(m_device, vk::CommandBufferLevel::ePrimary, "interface");
        slot.done =
            vk::Device(m_device.handle()).createFenceUnique({.flags = vk::FenceCreateFlagBits::eSignaled});
        slot.imageReady = vk::Device(m_device.handle()).createSemaphoreUnique({});
    }
}

Presenter::~Presenter() {
    try {
        vk::Device(m_device.handle()).waitIdle();
    } catch (const vk::Error&) {
        // Reported where somebody waits for a frame.
    }
}

bool Presenter::isStale() const {
    if (m_swapchain == nullptr || m_wanted != m_window.extent()) {
        return true;
    }
    // Some surfaces are suboptimal forever; making the same swapchain each frame would not help.
    return m_swapchain->state() > SwapchainState::suboptimal ||
           (m_swapchain->state() == SwapchainState::suboptimal &&
            m_swapchain->isOutgrown(m_device, m_ui.surface(), m_wanted));
}

bool Presenter::renew() {
    vk::Device(m_device.handle()).waitIdle();
    m_wanted = m_window.extent();
    try {
        if (m_isSurfaceLost) {
            m_swapchain.reset();
            m_ui.renewSurface(m_window);
            m_isSurfaceLost = false;
        }
        m_swapchain = std::make_unique<Swapchain>(m_device,
                                                  SwapchainOptions{.surface = m_ui.surface(),
                                                                   .format = m_format,
                                                                   .renderPass = *m_renderPass,
                                                                   .wanted = m_wanted,
                                                                   .pace = m_pace},
                                                  m_swapchain.get());
        return true;
    } catch (const vk::OutOfDateKHRError&) {
        m_swapchain.reset();
    } catch (const vk::SurfaceLostKHRError&) {
        m_swapchain.reset();
        loseSurface();
    }
    return false;
}

void Presenter::loseSurface() {
    constexpr int kMaxInTurn = 3;
    if (++m_surfacesLost > kMaxInTurn) {
        throw base::RunError("the window's surface was lost, and each new one too");
    }
    m_isSurfaceLost = true;
}

bool Presenter::draw(const PictureLayout& layout, ImDrawData* interface, image::ImageRgba8* capture) {
    const vk::Extent2D wanted = m_window.extent();
    if (wanted.width == 0 || wanted.height == 0 || (isStale() && !renew())) {
        return false;
    }
    std::optional<WindowCapture> reader;
    if (capture != nullptr) {
        reader.emplace(m_device, *m_swapchain);
    }
    const std::size_t index = m_frames % kFramesInFlight;
    Slot& slot = m_slots[index];
    waitFor(slot);
    if (layout.pictures < m_pictures.size()) {
        m_pictures.back()->forget();
    }
    for (const auto& picture : m_pictures) {
        picture->stage(index); // before an image is acquired, since memory may run out
    }
    const std::optional<std::uint32_t> image = m_swapchain->acquire(*slot.imageReady);
    if (image) {
        ++m_frames;
        vk::Device(m_device.handle()).resetFences(*slot.done);
        slot.pool->reset();
        const vk::CommandBuffer commands = slot.pool->next();
        commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        record(commands, m_swapchain->image(*image), layout, interface);
        if (reader) {
            reader->record(commands, m_swapchain->image(*image).image);
        }
        commands.end();
        submit(commands, slot, m_swapchain->image(*image));
        if (reader) {
            waitFor(slot); // whatever presenting ends with, the reader goes
        }
        m_swapchain->present(m_device.queue(), *image);
    }
    if (m_swapchain->state() == SwapchainState::lost) {
        loseSurface();
    }
    if (m_swapchain->state() > SwapchainState::suboptimal) {
        return false;
    }
    m_surfacesLost = 0;
    if (reader) {
        *capture = reader->fetch();
    }
    return true;
}

void Presenter::waitFor(const Slot& slot) const {
    const vk::Result waited =
        vk::Device(m_device.handle())
            .waitForFences(*slot.done, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
    vk::resultCheck(waited, "vkWaitForFences");
}

void Presenter::record(vk::CommandBuffer commands, const Swapchain::Image& target,
                       const PictureLayout& layout, ImDrawData* interface) {
    using PipelineStage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    for (const auto& picture : m_pictures) {
        picture->recordUpload(commands);
    }
    gpu::pipelineBarrier(commands, {gpu::imageBarrier(target.image, vk::ImageAspectFlagBits::eColor,
                                                      {PipelineStage::eAllTransfer, Access::eNone,
                                                       vk::ImageLayout::eUndefined},
                                                      {PipelineStage::eAllTransfer, Access::eTransferWrite,
                                                       vk::ImageLayout::eTransferDstOptimal})});
    commands.clearColorImage(target.image, vk::ImageLayout::eTransferDstOptimal, kBackground, kWhole);
    gpu::pipelineBarrier(commands, {gpu::imageBarrier(target.image, vk::ImageAspectFlagBits::eColor,
                                                      {PipelineStage::eAllTransfer, Access::eTransferWrite,
                                                       vk::ImageLayout::eTransferDstOptimal},
                                                      {PipelineStage::eAllTransfer, Access::eTransferWrite,
                                                       vk::ImageLayout::eTransferDstOptimal})});
    // The surface may have shrunk since the pictures were laid out.
    const vk::Extent2D window = m_swapchain->extent();
    const vk::Extent2D area{std::min(layout.extent.width, window.width),
                            std::min(layout.extent.height, window.height)};
    const double divider = layout.pictures > 1 ? layout.divider : 1.0;
    m_pictures[0]->recordBlit(commands, target.image, area, 0.0, divider);
    m_pictures[1]->recordBlit(commands, target.image, area, divider, 1.0);
    commands.beginRenderPass(
        {.renderPass = *m_renderPass, .framebuffer = *target.framebuffer, .renderArea = {{0, 0}, window}},
        vk::SubpassContents::eInline);
    const ImVec2 perUnit = interface->FramebufferScale;
    interface->DisplaySize = {
        std::min(interface->DisplaySize.x, static_cast<float>(window.width) / perUnit.x),
        std::min(interface->DisplaySize.y, static_cast<float>(window.height) / perUnit.y)};
    ImGui_ImplVulkan_RenderDrawData(interface, commands);
    commands.endRenderPass();
}

void Presenter::submit(vk::CommandBuffer commands, const Slot& slot, const Swapchain::Image& target) const {
    const vk::SemaphoreSubmitInfo wait{.semaphore = *slot.imageReady,
                                       .stageMask = vk::PipelineStageFlagBits2::eAllTransfer};
    // The window's pass hands its last transition to transfers, with a capture or without one.
    const vk::SemaphoreSubmitInfo signal{.semaphore = *target.drawn,
                                         .stageMask = vk::PipelineStageFlagBits2::eColorAttachmentOutput |
                                                      vk::PipelineStageFlagBits2::eAllTransfer};
    const vk::CommandBufferSubmitInfo buffer{.commandBuffer = commands};
    vk::Queue(m_device.queue())
        .submit2(vk::SubmitInfo2{.waitSemaphoreInfoCount = 1,
                                 .pWaitSemaphoreInfos = &wait,
                                 .commandBufferInfoCount = 1,
                                 .pCommandBufferInfos = &buffer,
                                 .signalSemaphoreInfoCount = 1,
                                 .pSignalSemaphoreInfos = &signal},
                 *slot.done);
}

} // namespace cdr::viewer
