#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/shadows/instance_bvh.h>
#include <cdr/measure/truth/mask_cut.h>
#include <cdr/measure/truth/shape.h>
#include <cdr/measure/truth/truth_texture.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cdr::measure {

/// What a light does at a pixel.
enum class Reach : std::uint8_t {
    nothing,  ///< background
    reached,  ///< the surface faces the light, and nothing lies between
    shadowed, ///< it faces the light, and something does
    away      ///< it faces away, gets less than a thousandth of the light, or is outside its cone or range
};

/// A pixel's surface and a light.
struct ShadowPixel {
    std::uint32_t id = 0; ///< object index + 1; 0 is background
    Reach reach = Reach::nothing;
    bool isDoubtful = false; ///< devices that filter a mask's texture a little differently may find otherwise

    bool operator==(const ShadowPixel&) const = default;
};

using ShadowImage = image::Raster<ShadowPixel>;

/// Casts a float64 ray through each pixel's centre, and from the surface there one to a light: each in every object's own
/// space. Opaque surfaces alone, and of masked ones what the mask keeps; for the light both sides of every triangle count.
/// Shares no code with the renderer's shadows.
class ShadowTruthCaster {
  public:
    /// @param scene must outlive the caster, and stay as it is.
    /// @param shapes of its meshes; must outlive the caster.
    /// base::InputError for an instance that is not finite or refers to what is not there.
    ShadowTruthCaster(const scene::Scene& scene, std::span<const Shape> shapes);

    /// @param light index into Scene::lights.
    /// base::InputError when the camera is not usable. The bits do not depend on the number of workers.
    ShadowImage cast(const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                     std::size_t light, platform::WorkerPool& workers) const;

    /// Whether nothing opaque lies between a surface and a light. Of masks' textures the finest level is read.
    /// @param fromCamera the surface's point less the camera's position.
    bool reaches(const glm::dvec3& camera, const glm::dvec3& fromCamera, std::size_t light) const;

    /// LitSurface::reached of a surface, 0 or 1 a light. A light that it faces away from counts as reaching it.
    /// @param fromCamera as for reaches(). @param normal of the surface, world axes.
    glm::dvec4 sharesAt(const glm::dvec3& camera, const glm::dvec3& fromCamera,
                        const glm::dvec3& normal) const;

  private:
    /// An instance, its rays' space included.
    struct Caster {
        const Shape* shape = nullptr; ///< null: it cannot be hit
        glm::dmat3 worldToObject{1.0};
        Sidedness sides = Sidedness::fronts;
        bool isMasked = false;
        double layer = 0.0; ///< scene::Material::layer
    };
    /// What a pixel shows, by the rule of TruthPixel.
    struct Hit {
        double at = kNoHit;   ///< parameter of the ray
        double rank = kNoHit; ///< less the layer
        std::uint32_t instance = 0;
        double doubtRank = kNoHit; ///< of the nearest doubtful point of masks that are no farther

        /// No surface of a layer that is farther is before it. Its own place is within, whatever is rounded.
        double lastAt(double layer) const { return std::max(at, rank + layer); }
    };
    /// A ray whose origin is relative to a camera.
    struct Ray {
        const glm::dvec3& camera;
        glm::dvec3 from;
        glm::dvec3 direction;
        double halfWidth = 0.0; ///< scene units: across it, what masks' textures are filtered over
    };
    /// What lies on the way to a light.
    struct Way {
        bool isBlocked = false;
        bool isDoubtful = false;
    };
    ObjectRay placed(const Ray& ray, std::uint32_t instance) const;
    /// Of one instance, along a pixel's ray.
    MaskedHit nearestOf(std::uint32_t instance, const scene::Camera& camera, const PixelRay& pixel,
                        const ViewRange& range) const;
    Hit nearest(const scene::Camera& camera, const PixelRay& pixel, const ViewRange& range) const;
    MaskedHit nearestOnWay(std::uint32_t instance, const Ray& ray, const ViewRange& range) const;
    Way wayOf(const Ray& ray, const ViewRange& range) const;
    /// @param point less the camera's position. @param way from there to a light. @param halfWidth Ray::halfWidth.
    Way wayTo(const glm::dvec3& camera, const glm::dvec3& point, const glm::dvec3& way,
              double halfWidth) const;
    ShadowPixel pixelAt(const scene::Camera& camera, const PixelRay& pixel,
                        const scene::PointLight& light) const;

    const scene::Scene* m_scene;
    std::unique_ptr<const TruthTextures> m_textures; ///< which masks are read from
    std::vector<Caster> m_casters;                   ///< by instance
    double m_nearestLayer = 0.0;                     ///< the largest, or 0
    InstanceBvh m_bvh;
};

} // namespace cdr::measure
