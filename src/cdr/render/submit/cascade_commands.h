#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/targets/gbuffer_rendering.h>

#include <cstddef>
#include <span>
#include <vector>

namespace cdr::render {

/// Where targets put a frame's work, in the order in which the device runs it. That is rendering scopes
/// that draw cascades, and whatever belongs between them.
class CascadeCommands {
  public:
    virtual ~CascadeCommands() = default;
    CascadeCommands() = default;
    CascadeCommands(const CascadeCommands&) = delete;
    CascadeCommands& operator=(const CascadeCommands&) = delete;

    /// Whether a cascade draws nothing for certain.
    virtual bool isEmpty(std::size_t cascade) const = 0;
    /// The cascades that may draw something, the nearest first; the farthest where none does, so that there
    /// is a scope to clear in.
    std::vector<std::size_t> drawnCascades(std::size_t cascades) const;

    /// Takes what comes next, outside any rendering scope. Ask again after drawScope().
    virtual vk::CommandBuffer primary() = 0;

    /// One rendering scope that draws the cascades in this order, at least one. Between two of them it clears depth where the
    /// scope says so.
    virtual void drawScope(const GBufferScope& scope, std::span<const std::size_t> cascades) = 0;
    /// A scope for each cascade, the farthest first, over images that are taken over from whoever used them before.
    /// @param cascades the nearest first. @param scopes of the farthest first.
    void drawScopes(std::span<const std::size_t> cascades, std::span<const GBufferScope> scopes);
};

} // namespace cdr::render
