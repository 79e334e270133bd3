#pragma once

#include <cdr/measure/certify/certifier.h>
#include <cdr/measure/truth/shape.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/scene.h>

#include <span>
#include <vector>

namespace cdr::measure {

/// Gives repairs their normals and colours; their object and distance are known. They are those of the surface at that
/// distance, lit, shadowed and tone-mapped in float64 as the renderer does it without effects. Blended surfaces before it are
/// laid over it in the order of their distances.
/// @param shapes of the scene's meshes.
void lightRepairs(const scene::Scene& scene, std::span<const Shape> shapes, const DrawnFrame& frame,
                  platform::WorkerPool& workers, std::vector<PixelRepair>& repairs);

} // namespace cdr::measure
