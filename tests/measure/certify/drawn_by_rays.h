#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/certify/certifier.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <cstdint>

namespace cdr::test {

/// A device in place of one that rasterises: rays that may miss their pixels' centres.
struct RayDevice {
    std::uint32_t width = 160;
    std::uint32_t height = 90;
    bool isOff = false; ///< each ray by up to an odd share of a pixel, kRayOff, along x and along y
};
inline constexpr double kRayOff = 1.0 / 9.0;
inline constexpr double kEightBits = 0x1p-9; ///< half a sub-pixel of 8 bits

/// What the device draws, as anchored depth in one cascade around what is seen says it.
/// @param snapPixels that it states.
measure::DrawnFrame drawnByRays(const scene::Scene& scene, const scene::Camera& camera, double snapPixels,
                                const RayDevice& device = {});

/// Pixels that show an object.
std::uint64_t shownBy(const measure::DrawnFrame& frame, std::uint32_t id);

measure::Certificate certified(const scene::Scene& scene, const measure::DrawnFrame& frame,
                               std::size_t threads = 1);

/// Pixels whose object differs from the truth once repairs are in, and repairs with another distance or no unit normal.
std::uint64_t wrongAfter(const scene::Scene& scene, const measure::DrawnFrame& frame,
                         const measure::Certificate& certificate);

} // namespace cdr::test
