#pragma once

#include <cdr/platform/worker_pool.h>
#include <cdr/render/occluders/order_margin.h>
#include <cdr/visibility/depth_tiles.h>

#include <cstdint>
#include <span>

namespace cdr::render {

/// Fills tiles from a depth buffer of near / view distance, 0 where nothing was drawn. The same for any number of workers.
/// @param zNdc row by row, `width` of them.
/// @param margin by which what is farther than a surface is hidden by it.
void reduceDepth(std::span<const float> zNdc, std::uint32_t width, double nearView, const OrderMargin& margin,
                 platform::WorkerPool& workers, visibility::DepthTiles& tiles);

} // namespace cdr::render
