#pragma once

#include <cdr/image/image.h>
#include <cdr/render/focus.h>
#include <cdr/scene/camera.h>

#include <array>
#include <cstdint>
#include <vector>

namespace cdr::experiments {

/// One of `count` cameras spread evenly over a lens (Vogel's spiral), turned to the point in focus on the
/// view axis. The turn stands in for a shifted lens. It bends the plane in focus by a share of about
/// (aperture / distance)^2, and leaves the middle of that plane in place.
/// @param index below count.
scene::Camera cameraOnLens(const scene::Camera& camera, const render::Focus& lens, std::uint32_t index,
                           std::uint32_t count);

/// The mean of pictures in linear light.
class LensReference {
  public:
    /// Pictures must all be of one size.
    void add(const image::ImageRgba8& picture);
    image::ImageRgba8 mean() const;

  private:
    std::uint32_t m_width = 0;
    std::uint32_t m_height = 0;
    std::uint32_t m_pictures = 0;
    std::vector<std::array<double, 3>> m_sums;
};

} // namespace cdr::experiments
