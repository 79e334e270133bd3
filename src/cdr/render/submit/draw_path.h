#pragma once

#include <cdr/render/frame.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/geometry/geometry_pass.h>
#include <cdr/render/submit/cascade_commands.h>
#include <cdr/visibility/cull.h>

#include <vulkan/vulkan.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cdr::render {

/// How a frame's draws come to be and reach the device. The picture is the same to the bit.
enum class Submission : std::uint8_t {
    secondaries, ///< workers record secondary command buffers, one primary executes them (thesis section 5.5)
    primaries,   ///< the control: workers record one primary per rendering scope; no secondaries, one submit
    gpuDriven,   ///< compute passes cull and bin into indirect draws (the thesis' future work)
};

inline constexpr std::array kSubmissions{Submission::secondaries, Submission::primaries,
                                         Submission::gpuDriven};

/// "secondaries", "primaries" or "gpu-driven".
std::string_view nameOf(Submission submission);
/// base::InputError with a suggestion for an unknown name.
Submission parseSubmission(std::string_view name);

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
    /// After the frame ran. False when room did not suffice, which it now does: bin and draw it again.
    virtual bool settle(FrameStats& stats) = 0;
};

} // namespace cdr::render
