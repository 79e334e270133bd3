#pragma once

#include <cdr/depth/cascade.h>
#include <cdr/render/frame.h>
#include <cdr/render/host_frame.h>
#include <cdr/render/surfaces.h>

#include <cstdint>
#include <optional>

namespace cdr::render {

/// Whether the frame can be drawn again before anybody sees it.
enum class Awaited : std::uint8_t { no, yes };

/// Whether a frame's draws were submitted ahead of the rest.
enum class DrawsSubmitted : std::uint8_t { withRest, ahead };

/// What becomes of a frame.
struct Delivery {
    std::optional<FrameCopy> copy{}; ///< to main memory
    FrameSync sync{};
    const HostFrame* host = nullptr; ///< into which it is recorded; null: it is submitted
    /// Of a view among others, for which all is culled already; null: the frame is culled and cut alone.
    const depth::Cascades* shared = nullptr;
    Awaited awaited = Awaited::no;
    DrawsSubmitted draws = DrawsSubmitted::withRest;
};

} // namespace cdr::render
