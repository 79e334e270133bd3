#pragma once

#include <cdr/gpu/commands.h>
#include <cdr/gpu/vulkan_hpp.h>

namespace cdr::render {

using PipelineStage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

/// Where depth attachments are used, and how.
inline constexpr auto kDepthStages = PipelineStage::eEarlyFragmentTests | PipelineStage::eLateFragmentTests;
inline constexpr auto kDepthAccess =
    Access::eDepthStencilAttachmentRead | Access::eDepthStencilAttachmentWrite;

/// Uses of images that barriers stand between: written as an attachment, read by fragment shaders, and copied from.
inline constexpr gpu::ImageUse kDrawnColor{PipelineStage::eColorAttachmentOutput,
                                           Access::eColorAttachmentWrite,
                                           vk::ImageLayout::eColorAttachmentOptimal};
/// Its layout needs no feature beside synchronization2; that of depth alone needs separateDepthStencilLayouts.
inline constexpr gpu::ImageUse kDrawnDepth{kDepthStages, Access::eDepthStencilAttachmentWrite,
                                           vk::ImageLayout::eAttachmentOptimal};
inline constexpr gpu::ImageUse kShaderRead{PipelineStage::eFragmentShader, Access::eShaderSampledRead,
                                           vk::ImageLayout::eShaderReadOnlyOptimal};
inline constexpr gpu::ImageUse kCopied{PipelineStage::eAllTransfer, Access::eTransferRead,
                                       vk::ImageLayout::eTransferSrcOptimal};

} // namespace cdr::render
