#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/shadows/light_view.h>
#include <cdr/shaders/shadows_shared.h>

#include <cstddef>
#include <cstdint>

namespace cdr::render {

/// Which light a map is of, and how surfaces are compared with it.
struct ReceiverOptions {
    std::size_t channel = 0;        ///< of the mask: the light's place in scene::shadowLights()
    bool isPlain = false;           ///< ShadowMethod::plain: places are taken from the camera
    std::uint32_t subPixelBits = 0; ///< to which vertices snap
    vk::Offset2D corner{};          ///< the map's first texel in its image
};

/// How the surfaces of a frame are compared with the map of a view.
shaders::ReceiverPush receiverPush(const LightView& view, const FrameView& frame,
                                   const ReceiverOptions& options);

} // namespace cdr::render
