#include <cdr/base/format_error.h>
#include <cdr/gpu/commands.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/rivals.h>

#include <rivals/atomic_pass.h>

namespace cdr::rivals {

namespace {

using AtomicStage = vk::PipelineStageFlagBits2;
using AtomicAccess = vk::AccessFlagBits2;

constexpr auto kStorage = vk::DescriptorType::eStorageBuffer;

gpu::Spirv vertexSpirvOf(Distance distance) {
    switch (distance) {
    case Distance::vertexPair:
        return kRivalPairVert;
    case Distance::object:
        return kRivalObjectVert;
    case Distance::view:
        break;
    }
    return kRivalViewVert;
}

gpu::Spirv nearestSpirvOf(const Rival& rival) {
    switch (rival.key) {
    case Key::log40:
        return rival.distance == Distance::object ? gpu::Spirv(kRivalLogObjectFrag)
                                                  : gpu::Spirv(kRivalLogViewFrag);
    case Key::fixed64:
        return kRivalFixedFrag;
    case Key::pair64:
        break;
    }
    return rival.distance == Distance::object ? gpu::Spirv(kRivalObjectFrag) : gpu::Spirv(kRivalPairFrag);
}

gpu::Spirv idsSpirvOf(const Rival& rival) {
    if (rival.key == Key::fixed64) {
        return kRivalFixedIdsFrag;
    }
    return rival.distance == Distance::object ? gpu::Spirv(kRivalObjectIdsFrag)
                                              : gpu::Spirv(kRivalPairIdsFrag);
}

vk::Format prepassFormat(const gpu::Device& device, const Rival& rival) {
    return rival.prepass ? vk::Format(device.depthFormat(depth::DepthFormat::d32f)) : vk::Format::eUndefined;
}

/// The rival, if there are shaders for it and the device can run them.
const Rival& requireDrawable(const gpu::Device& device, const Rival& rival) {
    const bool isThere = rival.key == Key::pair64  ? rival.distance != Distance::view
                         : rival.key == Key::log40 ? rival.distance != Distance::vertexPair
                                                   : rival.distance == Distance::object;
    if (!isThere) {
        throw base::InputError(
            "a rival of this distance and key is not drawn: it would be another one's equal");
    }
    requireFeatures(device.info(), rival);
    return rival;
}

gpu::Buffer makePixels(const gpu::Device& device, vk::Extent2D extent, std::size_t bytesPerPixel,
                       const std::string& name) {
    const std::size_t bytes = std::size_t{extent.width} * extent.height * bytesPerPixel;
    if (bytes > device.info().maxStorageBufferBytes) {
        throw base::runError("{} of {}x{} pixels take {} bytes, and a buffer of {} has {}", name,
                             extent.width, extent.height, bytes, device.info().name,
                             device.info().maxStorageBufferBytes);
    }
    return {device, bytes,
            vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferSrc |
                vk::BufferUsageFlagBits::eTransferDst,
            gpu::MemoryUse::deviceOnly, name};
}

gpu::Buffer hostCopyOf(const gpu::Device& device, const gpu::Buffer& buffer, const std::string& name) {
    return {device, buffer.size(), vk::BufferUsageFlagBits::eTransferDst, gpu::MemoryUse::hostReads, name};
}

} // namespace

AtomicPass::AtomicPass(const gpu::Device& device, const Rival& rival, vk::Extent2D extent)
    : m_rival(requireDrawable(device, rival)),
      m_extent(extent),
      m_depthFormat(prepassFormat(device, rival)),
      m_keys(makePixels(device, extent, sizeof(std::uint64_t), "rival keys")),
      m_keysOnHost(hostCopyOf(device, m_keys, "rival keys on the host")),
      m_setLayout(gpu::makeSetLayout(device,
                                     {hasIdPass() ? std::vector{kStorage, kStorage} : std::vector{kStorage},
                                      vk::ShaderStageFlagBits::eFragment},
                                     "rival buffers")),
      m_set(device, m_setLayout),
      m_layout(gpu::makePipelineLayout(device, {{m_setLayout}, {FrameDraws::pushRange()}}, "rival layout")) {
    m_set.setBuffer(0, m_keys);
    const std::uint32_t depthUse = rival.prepass ? shaders::kDepthSieves : shaders::kDepthNone;
    if (hasIdPass()) {
        m_ids = makePixels(device, extent, sizeof(std::uint32_t), "rival ids");
        m_idsOnHost = hostCopyOf(device, m_ids, "rival ids on the host");
        m_set.setBuffer(1, m_ids);
        m_whose = makePipeline(device, "rival", idsSpirvOf(rival), depthUse);
    }
    if (rival.prepass) {
        m_depth = gpu::Image(device,
                             {.extent = extent,
                              .format = m_depthFormat,
                              .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
                              .aspect = vk::ImageAspectFlagBits::eDepth},
                             "rival prepass");
        m_prepass = makePipeline(device, "rival prepass", {}, shaders::kDepthDecides);
    }
    m_nearest = makePipeline(device, "rival", nearestSpirvOf(rival), depthUse);
}

gpu::Pipeline AtomicPass::makePipeline(const gpu::Device& device, const char* name,
                                       const gpu::Spirv& fragment, std::uint32_t depthUse) const {
    return gpu::makeGraphicsPipeline(device, {.name = name,
                                              .vertexSpirv = vertexSpirvOf(m_rival.distance),
                                              .fragmentSpirv = fragment,
                                              .constants = {shaders::kDepthFormLinear, 0u, 0u, 0u, depthUse},
                                              .layout = m_layout,
                                              .bindings = FrameDraws::bindings(),
                                              .attributes = FrameDraws::attributes(),
                                              .colorFormats = {},
                                              .depthFormat = m_depthFormat,
                                              .writesDepth = depthUse == shaders::kDepthDecides,
                                              .depthCompare = vk::CompareOp::eGreaterOrEqual});
}

void AtomicPass::clear(vk::CommandBuffer commands) const {
    gpu::memoryBarrier(commands, AtomicStage::eFragmentShader | AtomicStage::eCopy,
                       AtomicAccess::eShaderStorageWrite, AtomicStage::eTransfer,
                       AtomicAccess::eTransferWrite);
    commands.fillBuffer(m_keys.handle(), 0, VK_WHOLE_SIZE, static_cast<std::uint32_t>(kNoKey));
    if (hasIdPass()) {
        commands.fillBuffer(m_ids.handle(), 0, VK_WHOLE_SIZE, 0);
    }
    gpu::memoryBarrier(commands, AtomicStage::eTransfer, AtomicAccess::eTransferWrite,
                       AtomicStage::eFragmentShader,
                       AtomicAccess::eShaderStorageRead | AtomicAccess::eShaderStorageWrite);
}

void AtomicPass::beginScope(vk::CommandBuffer commands, vk::AttachmentLoadOp load) const {
    const auto depth = render::depthAttachment(m_rival.prepass ? m_depth.view() : vk::ImageView(), load);
    render::beginRendering(commands, m_extent, {}, m_rival.prepass ? &depth : nullptr);
}

void AtomicPass::record(vk::CommandBuffer commands, const FrameDraws& draws) {
    const shaders::RivalPush push = KeyScale(m_rival, draws.view().camera).pushFor(m_extent.width);
    const auto drawBy = [&](const gpu::Pipeline& pipeline) {
        draws.record(commands, 0, {.layout = *m_layout, .compact = *pipeline, .wide = {}}, push);
    };
    clear(commands);
    if (m_rival.prepass) {
        gpu::pipelineBarrier(
            commands, {gpu::imageBarrier(m_depth.handle(), vk::ImageAspectFlagBits::eDepth,
                                         {render::kDepthStages, AtomicAccess::eDepthStencilAttachmentWrite,
                                          vk::ImageLayout::eUndefined},
                                         {render::kDepthStages, render::kDepthAccess,
                                          vk::ImageLayout::eAttachmentOptimal})});
    }
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 0, *m_set, {});
    beginScope(commands, vk::AttachmentLoadOp::eClear);
    draws.begin(commands);
    if (m_rival.prepass) {
        drawBy(m_prepass);
    }
    drawBy(m_nearest);
    commands.endRendering();
    if (!hasIdPass()) {
        return;
    }
    gpu::memoryBarrier(commands, AtomicStage::eFragmentShader | render::kDepthStages,
                       AtomicAccess::eShaderStorageWrite | AtomicAccess::eDepthStencilAttachmentWrite,
                       AtomicStage::eFragmentShader | render::kDepthStages,
                       AtomicAccess::eShaderStorageRead | AtomicAccess::eShaderStorageWrite |
                           render::kDepthAccess);
    beginScope(commands, vk::AttachmentLoadOp::eLoad);
    draws.begin(commands);
    drawBy(m_whose);
    commands.endRendering();
}

void AtomicPass::recordReadback(vk::CommandBuffer commands) {
    gpu::memoryBarrier(commands, AtomicStage::eFragmentShader, AtomicAccess::eShaderStorageWrite,
                       AtomicStage::eCopy, AtomicAccess::eTransferRead);
    commands.copyBuffer(m_keys.handle(), m_keysOnHost.handle(), vk::BufferCopy{.size = m_keys.size()});
    if (hasIdPass()) {
        commands.copyBuffer(m_ids.handle(), m_idsOnHost.handle(), vk::BufferCopy{.size = m_ids.size()});
    }
}

FramePixels AtomicPass::fetch(const render::FrameView& view) const {
    const std::size_t pixels = std::size_t{m_extent.width} * m_extent.height;
    FramePixels found{.ids = image::ImageU32(m_extent.width, m_extent.height),
                      .distanceView = image::Raster<double>(m_extent.width, m_extent.height)};
    m_keysOnHost.invalidate();
    const std::span<const std::uint64_t> keys = m_keysOnHost.as<std::uint64_t>(pixels);
    const KeyScale scale(m_rival, view.camera);
    for (std::size_t i = 0; i < pixels; ++i) {
        found.distanceView.pixels[i] = scale.distanceView(keys[i]);
        found.ids.pixels[i] = ~static_cast<std::uint32_t>(keys[i]) & shaders::kIdMask; // 0 of kNoKey
    }
    if (hasIdPass()) {
        m_idsOnHost.invalidate();
        const std::span<const std::uint32_t> ids = m_idsOnHost.as<std::uint32_t>(pixels);
        found.ids.pixels.assign(ids.begin(), ids.end());
    }
    return found;
}

} // namespace cdr::rivals
