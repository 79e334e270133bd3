#include "picture_texture.h"

#include <cdr/gpu/commands.h>

#include <cmath>
#include <cstring>
#include <utility>

namespace cdr::viewer {

namespace {

constexpr vk::ImageSubresourceLayers kLayers{vk::ImageAspectFlagBits::eColor, 0, 0, 1};

/// Between a copy into the picture and the blits out of it, either way.
vk::ImageMemoryBarrier2 barrierBetween(const gpu::Image& image, vk::ImageLayout from, vk::ImageLayout to) {
    constexpr auto kStage = vk::PipelineStageFlagBits2::eAllTransfer;
    return gpu::imageBarrier(
        image.handle(), vk::ImageAspectFlagBits::eColor, {kStage, vk::AccessFlagBits2::eTransferWrite, from},
        {kStage, vk::AccessFlagBits2::eTransferRead | vk::AccessFlagBits2::eTransferWrite, to});
}

} // namespace

void PictureTexture::forget() {
    m_pending.reset();
    release();
}

void PictureTexture::release() {
    m_staged = nullptr;
    if (isEmpty()) {
        return;
    }
    vk::Device(m_device.handle()).waitIdle(); // a frame in flight may still read it
    m_image = {};
    for (gpu::Buffer& staging : m_staging) {
        staging = {};
    }
}

void PictureTexture::stage(std::size_t slot) {
    if (m_pending == nullptr || m_pending->pixels.empty()) {
        return;
    }
    const vk::Extent2D extent{m_pending->width, m_pending->height};
    if (!isEmpty() && m_image.options().extent != extent) {
        release();
    }
    const std::size_t bytes = m_pending->pixels.size() * sizeof(image::Rgba8);
    gpu::Buffer& staging = m_staging[slot];
    if (staging.size() != bytes) {
        staging = gpu::Buffer(m_device, bytes, vk::BufferUsageFlagBits::eTransferSrc,
                              gpu::MemoryUse::hostWrites, m_name + " staging");
    }
    if (isEmpty()) { // last, since it has no pixels until they are copied
        m_image =
            gpu::Image(m_device,
                       {.extent = extent,
                        .format = vk::Format::eR8G8B8A8Unorm,
                        // gpu::Image makes a view, which transfers alone would not allow
                        .usage = vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eTransferSrc |
                                 vk::ImageUsageFlagBits::eSampled},
                       m_name);
    }
    std::memcpy(staging.mapped(), m_pending->pixels.data(), bytes);
    staging.flush();
    m_pending.reset();
    m_staged = &staging;
}

void PictureTexture::recordUpload(vk::CommandBuffer commands) {
    const gpu::Buffer* staged = std::exchange(m_staged, nullptr);
    if (staged == nullptr) {
        return;
    }
    const vk::Extent2D extent = m_image.options().extent;
    gpu::pipelineBarrier(commands, {barrierBetween(m_image, vk::ImageLayout::eUndefined,
                                                   vk::ImageLayout::eTransferDstOptimal)});
    commands.copyBufferToImage(
        staged->handle(), m_image.handle(), vk::ImageLayout::eTransferDstOptimal,
        vk::BufferImageCopy{.imageSubresource = kLayers, .imageExtent = {extent.width, extent.height, 1}});
    gpu::pipelineBarrier(commands, {barrierBetween(m_image, vk::ImageLayout::eTransferDstOptimal,
                                                   vk::ImageLayout::eTransferSrcOptimal)});
}

void PictureTexture::recordBlit(vk::CommandBuffer commands, vk::Image target, const vk::Extent2D& area,
                                double left, double right) const {
    if (isEmpty()) {
        return;
    }
    const vk::Extent2D extent = m_image.options().extent;
    const auto column = [](double share, std::uint32_t width) {
        return static_cast<std::int32_t>(std::lround(share * width));
    };
    const std::int32_t from = column(left, extent.width);
    const std::int32_t to = column(right, extent.width);
    const std::int32_t targetFrom = column(left, area.width);
    const std::int32_t targetTo = column(right, area.width);
    if (from >= to || targetFrom >= targetTo) {
        return;
    }
    const vk::ImageBlit region{
        .srcSubresource = kLayers,
        .srcOffsets = {{vk::Offset3D{from, 0, 0},
                        vk::Offset3D{to, static_cast<std::int32_t>(extent.height), 1}}},
        .dstSubresource = kLayers,
        .dstOffsets = {{vk::Offset3D{targetFrom, 0, 0},
                        vk::Offset3D{targetTo, static_cast<std::int32_t>(area.height), 1}}}};
    const bool isExact = extent == area;
    commands.blitImage(m_image.handle(), vk::ImageLayout::eTransferSrcOptimal, target,
                       vk::ImageLayout::eTransferDstOptimal, region,
                       isExact ? vk::Filter::eNearest : vk::Filter::eLinear);
}

} // namespace cdr::viewer
