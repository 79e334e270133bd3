#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/shadows/light_view.h>
#include <cdr/shaders/shadows_shared.h>

#include <cstdint>

namespace cdr::render {

/// How surfaces are compared with a map.
struct ReceiverOptions {
    bool isPlain = false;           ///< ShadowMethod::plain: places are taken from the camera
    std::uint32_t subPixelBits = 0; ///< to which vertices snap
    vk::Offset2D corner{};          ///< the map's first texel in its image
};

/// How the surfaces of a frame are compared with the map of a view.
shaders::ReceiverPush receiverPush(const LightView& view, const FrameView& frame,
                                   const ReceiverOptions& options);

} // namespace cdr::render
