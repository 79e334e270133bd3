#pragma once

#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/screen_bounds.h>
#include <cdr/measure/truth/shape.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::measure {

/// An instance that may cover pixels, ready for rays.
struct VisibleInstance {
    const Shape* shape = nullptr;
    std::uint32_t instance = 0; ///< index in the scene
    Sidedness sides = Sidedness::fronts;
    std::uint32_t id = 0; ///< object index + 1
    double nearestView = 0.0;
    double layer = 0.0; ///< scene::Material::layer
    PixelRect pixels{};
    PlacedCamera camera;

    /// What decides which surface is seen: the least that any hit can have.
    double nearestRank() const { return nearestView - layer; }
};

/// base::InputError for an instance that is not finite or refers to what is not there.
void requireSoundInstance(const scene::Scene& scene, std::size_t instance);

/// The instances that may cover pixels of the picture, by nearest view distance less the layer, then by
/// instance index. base::InputError as requireSoundInstance().
/// @param shapes one per mesh of the scene; must outlive the result.
/// @param marginPixels as footprint() takes it: what lies so far off the pixel centres counts too.
std::vector<VisibleInstance> visibleInstances(const scene::Scene& scene, std::span<const Shape> shapes,
                                              const scene::Camera& camera, std::uint32_t width,
                                              std::uint32_t height, platform::WorkerPool& workers,
                                              double marginPixels = kMinMargin);

} // namespace cdr::measure
