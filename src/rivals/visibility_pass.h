#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/image/image.h>

#include <rivals/frame_draws.h>

namespace cdr::rivals {

/// What a frame shows, in main memory.
struct FramePixels {
    image::ImageU32 ids;                ///< object index + 1, 0 for background
    image::Raster<double> distanceView; ///< infinity for background
};

/// Finds the nearest surface of each pixel: its id and its distance, on the device.
class VisibilityPass {
  public:
    virtual ~VisibilityPass() = default;
    VisibilityPass() = default;
    VisibilityPass(const VisibilityPass&) = delete;
    VisibilityPass& operator=(const VisibilityPass&) = delete;

    /// A whole frame.
    virtual void record(vk::CommandBuffer commands, const FrameDraws& draws) = 0;
    /// Copies what was found to main memory, after record().
    virtual void recordReadback(vk::CommandBuffer commands) = 0;
    /// What was copied, once the device is done.
    virtual FramePixels fetch(const render::FrameView& view) const = 0;
};

} // namespace cdr::rivals
