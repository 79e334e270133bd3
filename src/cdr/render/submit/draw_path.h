#pragma once

#include <cdr/gpu/commands.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/geometry/geometry_pass.h>
#include <cdr/render/submit/cascade_commands.h>
#include <cdr/render/submit/submission.h>
#include <cdr/visibility/cull_cells.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace cdr::render {

/// What captures call a rendering scope: "cascade 2", or "cascades 4 to 0" in the order in which they are drawn.
std::string labelOf(std::span<const std::size_t> cascades);

/// A host's part in the commands of a frame.
struct HostCommands {
    vk::CommandBuffer
        into{}; ///< recording; takes the frame in place of buffers of the path's own. Null: those
    /// Draws the host's objects, inside the rendering scope of a cascade. Empty: there are none.
    std::function<void(vk::CommandBuffer commands, std::size_t cascade)> draw{};
};

/// One way for a frame's draws to reach the device, for one frame slot: it owns the slot's command pools and
/// lists. So a slot's frame must have finished before its next begins.
///
/// A frame is bin(), begin(), whatever targets and passes put into it, end(), noteLaunched() and, once it ran, settle(). In
/// between, endDraws() may divide it.
class DrawPath : public CascadeCommands {
  public:
    /// Whether bin() reads the visible list.
    virtual bool needsVisible() const = 0;
    /// Decides what each cascade draws; base::RunError when that needs too much memory.
    /// @param visible what the camera sees; empty where needsVisible() is false and nobody else needs it.
    virtual void bin(const FrameView& view, const visibility::VisibleCells& visible, FrameStats& stats) = 0;
    /// Takes back the slot's command buffers and starts the frame's. Reads what bin() decided.
    /// @param host must live until end(); empty for the path of Submission::primaries, which has no one command buffer.
    virtual void begin(const FrameView& view, const HostCommands& host) = 0;
    /// Ends the command buffers that hold the draws: these are to run first, in this order. Whatever follows goes into others.
    /// Valid until primary() is asked for. A host's is left recording, and nothing is to run.
    virtual std::span<const vk::CommandBuffer> endDraws(const FrameView& view) = 0;
    /// Ends the frame's command buffers, or those after endDraws(): these are to run, in this order. Valid until the next
    /// begin(). A host's is left recording, and nothing is to run.
    virtual std::span<const vk::CommandBuffer> end(const FrameView& view) = 0;
    /// What end() returned was submitted, or is in a host's commands, which it will submit.
    virtual void noteLaunched() {}
    /// The host does not submit its commands after all.
    virtual void noteDropped() {}
    /// The records of the facets that a visibility buffer refers to, once begun; none for a G-buffer.
    virtual vk::BufferView facets() const { return {}; }
    /// After the frame ran. False when room did not suffice, which it now does for what is binned next.
    virtual bool settle(FrameStats& stats) = 0;
};

/// A path whose draws are all in one primary: a host's, or one of its own.
class OnePrimaryPath : public DrawPath {
  public:
    vk::CommandBuffer primary() override { return m_primary; }
    void drawScope(const GBufferScope& scope, std::span<const std::size_t> cascades) override;
    std::span<const vk::CommandBuffer> endDraws(const FrameView& view) override;
    std::span<const vk::CommandBuffer> end(const FrameView& view) override;

  protected:
    /// @param flags of its rendering scopes.
    OnePrimaryPath(const gpu::Device& device, const std::string& name, vk::RenderingFlags flags);
    /// @param host recording; null: it begins its own.
    void beginPrimary(vk::CommandBuffer host);
    /// Inside a rendering scope.
    virtual void drawCascade(std::size_t cascade) = 0;

  private:
    const gpu::Device& m_device;
    gpu::CommandPool m_pool;
    vk::RenderingFlags m_flags;
    vk::CommandBuffer m_primary;
    vk::CommandBuffer m_endedDraws; ///< by endDraws()
    bool m_isOwn = true;            ///< the primary; else it is a host's
};

} // namespace cdr::render
