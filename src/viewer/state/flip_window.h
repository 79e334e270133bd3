#pragma once

#include <cdr/image/image.h>
#include <cdr/render/frame.h>

#include <cstdint>

namespace cdr::viewer {

/// Where a technique flickered in the last second. A pixel flickers if its shown object changed from one frame to
/// the next while that of the anchored answer did not. It must be off edges of that answer in both frames.
class FlipWindow {
  public:
    static constexpr double kSeconds = 1.0;

    /// @param frame what was shown; @param reference the same camera's frame by referenceTechnique();
    /// @param seconds a clock that does not run back. Frames of another size, and clear(), begin again.
    /// base::InputError when frame and reference differ in size.
    void add(const render::Frame& frame, const render::Frame& reference, double seconds);
    void clear(); ///< gives its memory back, too

    /// Red where a pixel flipped, fading to the dim grey picture over kSeconds. base::InputError unless
    /// `frame` has the size of the last one added.
    void paint(const render::Frame& frame, image::ImageRgba8& picture) const;

    /// Pixels that flipped in the last frame added, and within kSeconds of it.
    std::uint64_t flipsNow() const { return m_flipsNow; }
    std::uint64_t pixelsInWindow() const;

  private:
    struct Shown {
        image::ImageU32 ids;
        image::ImageU32 answer;
        image::Raster<std::uint8_t> inner;
    };
    Shown m_before;
    Shown m_now;                   ///< kept so that a warm frame allocates nothing
    image::ImageFloat m_flippedAt; ///< seconds since m_start; before it where never
    double m_start = 0.0;
    double m_seconds = 0.0;
    std::uint64_t m_flipsNow = 0;
};

} // namespace cdr::viewer
