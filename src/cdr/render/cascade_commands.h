#pragma once

#include <cdr/base/worker_pool.h>
#include <cdr/render/gbuffer_rendering.h>

#include <vulkan/vulkan.hpp>

namespace cdr::render {

/// Where targets put a frame's work, in the order in which the device runs it: rendering scopes that draw
/// cascades, and whatever belongs between them.
class CascadeCommands {
  public:
    virtual ~CascadeCommands() = default;
    CascadeCommands() = default;
    CascadeCommands(const CascadeCommands&) = delete;
    CascadeCommands& operator=(const CascadeCommands&) = delete;

    /// Takes what comes next, outside any rendering scope. Ask again after drawScope().
    virtual vk::CommandBuffer primary() = 0;

    /// One rendering scope that clears depth, draws the cascades from the nearest on, and stores the colours.
    virtual void drawScope(const GBufferScope& scope, base::IndexRange cascades) = 0;
};

} // namespace cdr::render
