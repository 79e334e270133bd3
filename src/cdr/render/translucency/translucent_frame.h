#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/translucency/fragment_counter.h>
#include <cdr/render/translucency/translucent_draws.h>
#include <cdr/render/translucency/translucent_shadows.h>

namespace cdr::render {

/// What a method of translucency draws one frame with.
struct TranslucentFrame {
    const TranslucentDraws& draws;
    vk::DescriptorSet surroundings;    ///< set 1: the opaque G-buffer, ready to be read, and the lights
    const gpu::Image& lit;             ///< linear light, a colour attachment; what is drawn is laid over it
    const FragmentCounter* counter;    ///< begun; null to count nothing
    const TranslucentShadows* shadows; ///< prepared; null where surfaces receive none
};

} // namespace cdr::render
