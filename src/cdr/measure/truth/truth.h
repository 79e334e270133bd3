#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/shape.h>
#include <cdr/measure/truth/truth_texture.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace cdr::measure {

/// What a perfect renderer sees through one pixel's centre. The nearest surface is the one whose distance, less its
/// material's layer, is least. If that is the same to the last bit, it is the surface of the last instance in the scene's
/// order. The renderer draws it so too.
struct TruthPixel {
    std::uint32_t id = 0;       ///< object index + 1 of the nearest surface; 0 is background
    std::uint32_t secondId = 0; ///< the nearest surface of another object along the same ray; 0 if none
    /// View distance of the nearest surface; infinity for background.
    double distanceView = std::numeric_limits<double>::infinity();
    /// View distance of the second; infinity if none.
    double secondDistanceView = std::numeric_limits<double>::infinity();

    float layer = 0.0f; ///< of the nearest surface's material
    float secondLayer = 0.0f;

    /// By how much the nearest surface is before the second, layers included.
    double gapView() const { return (secondDistanceView - secondLayer) - (distanceView - layer); }

    bool operator==(const TruthPixel&) const = default;
};

/// What a perfect renderer sees through all pixels.
struct TruthImage : image::Raster<TruthPixel> {
    /// 1 where a masked surface may be cut away or stay, as devices filter textures, and that decides what is seen.
    /// Without pixels where nothing in view is masked.
    image::Raster<std::uint8_t> doubtful;

    using Raster::Raster;
    TruthImage() = default;
    explicit TruthImage(Raster truth) : Raster(std::move(truth)) {}

    bool operator==(const TruthImage&) const = default;
};

/// Casts one float64 ray through every pixel centre, in each object's own space so it stays exact far away.
/// Shares no code with the renderer's projection.
///
/// Visible is what lies within the camera's [near, far], both ends included, and is not the back of a
/// single-sided material. Behind an invisible surface the object's next one counts. Fronts are
/// counter-clockwise in object space, so a mirroring basis keeps the same faces in front. Blended surfaces
/// are seen through (castLayers() has them). What a mask cuts away is not seen. An instance whose basis is flat (no
/// inverse) is invisible.
///
/// Prepares the scene's meshes once, for any number of pictures.
class TruthCaster {
  public:
    /// @param scene must outlive the caster; instances may change, and meshes that follow() is told of. Textures may not.
    /// base::InputError when a mesh is unsound.
    TruthCaster(const scene::Scene& scene, platform::WorkerPool& workers);

    /// The picture of width x height pixels. Its bits do not depend on the number of workers.
    /// base::InputError for a camera that is not usable and for a picture without pixels. The same for an
    /// instance that is not finite, or refers to what does not exist. base::RunError when the picture takes more memory
    /// than is free.
    TruthImage cast(const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                    platform::WorkerPool& workers) const;
    /// The same of the pixels that are not 0 in `wanted` alone; the others stay as they begin.
    TruthImage cast(const scene::Camera& camera, const image::Raster<std::uint8_t>& wanted,
                    platform::WorkerPool& workers) const;

    /// Reads again the meshes whose vertices changed. base::InputError when one is unsound.
    void follow(std::span<const std::uint32_t> meshes, platform::WorkerPool& workers);

    /// Of each mesh.
    const std::vector<Shape>& shapes() const { return m_shapes; }
    /// Which masks are read from.
    const TruthTextures& textures() const { return *m_textures; }

  private:
    void castInto(const scene::Camera& camera, const image::Raster<std::uint8_t>* wanted,
                  platform::WorkerPool& workers, TruthImage& truth) const;

    const scene::Scene* m_scene;
    std::vector<Shape> m_shapes; ///< per mesh
    std::unique_ptr<const TruthTextures> m_textures;
};

/// One picture by a TruthCaster of its own.
TruthImage castTruth(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                     std::uint32_t height, platform::WorkerPool& workers);

} // namespace cdr::measure
