#pragma once

#include <cdr/render/frame.h>

#include <output/columns.h>
#include <ranks/ranks.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace cdr::cli {

/// What of a command's frames its ranks divide among them.
enum class FrameDivision : std::uint8_t {
    frames,  ///< each frame is one rank's
    cascades ///< each rank draws neighbouring cascades of every frame, which are laid over each other
};

/// "frames" or "cascades"; base::InputError with a suggestion for another name.
FrameDivision parseFrameDivision(std::string_view name);

/// The steps by which a frame becomes a result.
struct FrameSteps {
    std::function<render::Frame(std::size_t frame)> draw;
    /// Of a whole frame: what take() is given.
    std::function<output::Json(std::size_t frame, render::Frame drawn)> describe;
    std::function<void(std::size_t frame, output::Json made)> take; ///< on the first rank, in order
};

/// Draws those frames, which ascend. A rank is given frames in ascending order.
void makeFrames(ranks::Ranks& ranks, FrameDivision division, const std::vector<std::size_t>& frames,
                const FrameSteps& steps);

} // namespace cdr::cli
