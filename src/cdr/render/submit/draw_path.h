#pragma once

#include <cdr/depth/cascade.h>
#include <cdr/render/frame.h>
#include <cdr/render/geometry/geometry_pass.h>
#include <cdr/render/submit/cascade_commands.h>
#include <cdr/visibility/cull.h>
#include <cdr/visibility/level_choice.h>

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

/// One frame's camera and its cascades: what draws follow from.
struct CutView {
    const scene::Camera& camera;
    double aspect = 1.0; ///< width over height
    /// What the camera sees; empty where DrawPath::needsVisible() is false and nobody else needs it.
    const visibility::VisibleList& visible;
    const depth::Cascades& clipRanges;      ///< depth::clipRange() of each cascade, nearest first
    std::span<const CascadeDraws> cascades; ///< as many
    visibility::LevelRule levels{};         ///< which level of detail each draw is of
};

/// One way for a frame's draws to reach the device, for one frame slot: it owns the slot's command pools and
/// lists, so a slot's frame must have finished before its next begins.
///
/// A frame is bin(), begin(), whatever targets and passes put into it, end(), and once it ran, settle().
class DrawPath : public CascadeCommands {
  public:
    /// Whether bin() reads the visible list.
    virtual bool needsVisible() const = 0;
    /// Decides what each cascade draws; base::RunError, with both figures, when that needs too much memory.
    virtual void bin(const CutView& view, FrameStats& stats) = 0;
    /// Takes back the slot's command buffers and starts the frame's. Reads what bin() decided.
    virtual void begin(const CutView& view) = 0;
    /// Ends the frame's command buffers: these are to run, in this order. Valid until the next begin().
    virtual std::span<const vk::CommandBuffer> end(const CutView& view) = 0;
    /// After the frame ran. False when room did not suffice, which it now does: bin and draw it again.
    virtual bool settle(FrameStats& stats) = 0;
};

} // namespace cdr::render
