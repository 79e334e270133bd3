#pragma once

#include <cdr/image/image.h>
#include <cdr/platform/worker_pool.h>

#include <cstdint>

namespace cdr::scenes {

/// The linear grey of paintConcrete() on average, which a material's colour is to be divided by.
inline constexpr float kConcreteMean = 0.8f;

/// A slab of a runway from above, 60 m long and wide: grain, stains and joints, from noise alone.
/// @param side texels in each direction, at least 1.
image::ImageRgba8 paintConcrete(std::uint32_t side, platform::WorkerPool& workers);

} // namespace cdr::scenes
