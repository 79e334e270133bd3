#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/truth.h>

#include <cstdint>
#include <optional>

namespace cdr::measure {

/// What was rendered in one frame and what should have been.
struct IdFrame {
    image::ImageU32 ids;
    TruthImage truth;
};

/// Flicker between frames.
struct FlipCount {
    std::uint64_t flips = 0;    ///< see countFlips()
    std::uint64_t compared = 0; ///< pixels where the truth stays the same

    /// None where no pixel can be compared.
    std::optional<double> perThousand() const {
        return compared > 0
                   ? std::optional(1000.0 * static_cast<double>(flips) / static_cast<double>(compared))
                   : std::nullopt;
    }
    FlipCount& operator+=(const FlipCount& other);
    bool operator==(const FlipCount&) const = default;
};

/// Per pixel: 1 where both frames are inner (innerMask()) and show the same object in truth, else 0.
/// base::InputError when the sizes differ.
image::Raster<std::uint8_t> steadyMask(const TruthImage& before,
                                       const image::Raster<std::uint8_t>& innerBefore,
                                       const TruthImage& after,
                                       const image::Raster<std::uint8_t>& innerAfter);

/// What each frame of a scene should show, and what of it stays from the frame before.
struct SceneTruth {
    TruthImage truth{};
    image::Raster<std::uint8_t> inner{};                 ///< innerMask()
    std::optional<image::Raster<std::uint8_t>> steady{}; ///< steadyMask(); none in the first frame

    /// Goes on to the next frame. base::InputError when the sizes differ.
    void add(TruthImage next);
};

/// A flip is a pixel off edges whose true object stays from one frame to the next while the drawn one changes. So at
/// least one of the two drawn objects is wrong. A wrong pixel that shows the same object in both frames does not flip.
/// base::InputError when the sizes differ.
FlipCount countFlips(const image::ImageU32& idsBefore, const image::ImageU32& idsAfter,
                     const image::Raster<std::uint8_t>& steady);

/// countFlips() over the two frames' steadyMask().
FlipCount countFlips(const IdFrame& before, const IdFrame& after);

} // namespace cdr::measure
