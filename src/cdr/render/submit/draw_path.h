#pragma once

#include <cdr/render/frame.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/geometry/geometry_pass.h>
#include <cdr/render/submit/cascade_commands.h>
#include <cdr/render/submit/submission.h>
#include <cdr/visibility/cull.h>

#include <vulkan/vulkan.hpp>

#include <span>
#include <string>

namespace cdr::render {

/// What captures call a rendering scope: "cascade 2" or "cascades 0 to 4".
std::string labelOf(host::IndexRange cascades);

/// One way for a frame's draws to reach the device, for one frame slot: it owns the slot's command pools and
/// lists, so a slot's frame must have finished before its next begins.
///
/// A frame is bin(), begin(), whatever targets and passes put into it, end(), and once it ran, settle().
class DrawPath : public CascadeCommands {
  public:
    /// Whether bin() reads the visible list.
    virtual bool needsVisible() const = 0;
    /// Decides what each cascade draws; base::RunError, with both figures, when that needs too much memory.
    /// @param visible what the camera sees; empty where needsVisible() is false and nobody else needs it.
    virtual void bin(const FrameView& view, const visibility::VisibleList& visible, FrameStats& stats) = 0;
    /// Takes back the slot's command buffers and starts the frame's. Reads what bin() decided.
    virtual void begin(const FrameView& view) = 0;
    /// Ends the frame's command buffers: these are to run, in this order. Valid until the next begin().
    virtual std::span<const vk::CommandBuffer> end(const FrameView& view) = 0;
    /// The records of the facets that a visibility buffer refers to, once begun; none for a G-buffer.
    virtual vk::BufferView facets() const { return {}; }
    /// After the frame ran. False when room did not suffice, which it now does: bin and draw it again.
    virtual bool settle(FrameStats& stats) = 0;
};

} // namespace cdr::render
