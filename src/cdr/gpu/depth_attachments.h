#pragma once

#include <cdr/depth/format.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <array>

namespace cdr::gpu {

/// Vulkan's formats that hold a depth::DepthFormat.
struct DepthAttachments {
    vk::Format alone;
    vk::Format withStencil;
};

/// By depth::DepthFormat.
inline constexpr std::array<DepthAttachments, depth::kDepthFormats.size()> kDepthAttachments{{
    {vk::Format::eD16Unorm, vk::Format::eD16UnormS8Uint},
    {vk::Format::eX8D24UnormPack32, vk::Format::eD24UnormS8Uint},
    {vk::Format::eD32Sfloat, vk::Format::eD32SfloatS8Uint},
}};

} // namespace cdr::gpu
