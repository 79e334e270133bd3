#pragma once

#include <cdr/gpu/device.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/geometry/snapping.h>

#include <cstdint>

namespace cdr::render_test {

/// How far the farthest drawn surface lies from where float64 has it, in pixels along x and along y. Measured on boxes turned
/// every way. Rounding vertices to b sub-pixel bits moves a surface by up to 2^-(b + 1).
/// @param snapBits, snapping as render::RenderOptions has them.
double measureReach(const gpu::Device& device, std::uint32_t snapBits,
                    render::Snapping snapping = render::Snapping::byDevice);

/// How far the device may move a surface: 0 where measureReach() finds that it does not, else what its limits say.
double snapReach(const gpu::Device& device);

/// Whether the device draws a floor right that reaches from behind the camera to the horizon. Some take a triangle's plane
/// from corners that were snapped before they were clipped, and these corners lie on one line.
bool drawsToTheHorizon(const gpu::Device& device);

/// 2^-(bits + 1).
double halfSubPixel(std::uint32_t bits);

/// Per pixel: 1 off edges where the two nearest surfaces lie so close that moving both by `reachPixels` may swap them.
image::Raster<std::uint8_t> swappable(const measure::TruthImage& truth, double reachPixels);

/// Wrong pixels off edges, but those where the second surface shows and is swappable.
std::uint64_t wrongBeyond(const image::ImageU32& ids, const measure::TruthImage& truth, double reachPixels);

} // namespace cdr::render_test
