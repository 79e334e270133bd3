#pragma once

#include <cdr/gpu/vulkan_hpp.h>

namespace cdr::render {

using PipelineStage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

/// Where depth attachments are used, and how.
inline constexpr auto kDepthStages = PipelineStage::eEarlyFragmentTests | PipelineStage::eLateFragmentTests;
inline constexpr auto kDepthAccess =
    Access::eDepthStencilAttachmentRead | Access::eDepthStencilAttachmentWrite;

} // namespace cdr::render
