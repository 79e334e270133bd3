#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/surface_hit.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/measure/truth/truth_finish.h>
#include <cdr/measure/truth/truth_texture.h>
#include <cdr/measure/truth/visible_instances.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace cdr::measure {

class ShadowTruthCaster;

/// What a pixel shows.
struct ShadedPixel {
    image::Rgba8 color{};      ///< sRGB, lit
    glm::dvec3 normal{0.0};    ///< world axes, unit; 0 for background
    glm::dvec3 baseColor{0.0}; ///< linear; 0 for background
};

/// Lights pixels whose object and distance are known, in float64 as the shading pass does it. Blended surfaces are left out. It
/// shares no code with the renderer.
class TruthShader {
  public:
    /// Scene, camera, textures and shadows must outlive the shader.
    /// @param visible of the scene's instances, at least those of objects that are shown. @param shadows null where lights reach
    /// everything.
    TruthShader(const scene::Scene& scene, const TruthTextures& textures, const scene::Camera& camera,
                const glm::uvec2& size, std::vector<VisibleInstance> visible,
                const ShadowTruthCaster* shadows, const TruthFinish& finish);

    /// The background where the object is not met. Tries each triangle of the object.
    /// @param id object index + 1, 0 for background.
    ShadedPixel at(std::uint32_t x, std::uint32_t y, std::uint32_t id, double distanceView) const;

  private:
    std::vector<SurfaceHit> hitsOn(std::uint32_t x, std::uint32_t y, std::uint32_t id) const;

    const scene::Scene& m_scene;
    const scene::Camera& m_camera;
    PixelSlopes m_slopes;
    const TruthTextures& m_textures;
    std::vector<VisibleInstance> m_visible; ///< by object
    const ShadowTruthCaster* m_shadows;
    TruthFinish m_finish;
};

/// The picture a renderer without depth errors shows: the true surface of every pixel, lit by a TruthShader. 8-bit sRGB, within a
/// step or two of a rendered picture wherever that shows the same object. It has no shadows. It is neither exposed nor tone
/// mapped, so under a sky or in air it is like a picture that is told not to be (render::ToneMap::none) alone.
/// @param caster that cast `truth` from the same scene and camera.
image::ImageRgba8 shadeTruth(const scene::Scene& scene, const TruthCaster& caster,
                             const scene::Camera& camera, const TruthImage& truth,
                             platform::WorkerPool& workers);

/// The truth-ordered render: `picture` where it shows the true object, the true surface's colour elsewhere.
/// The two differ only by what depth got wrong, not by rounding. base::InputError when the sizes differ.
image::ImageRgba8 orderByTruth(const image::ImageRgba8& picture, const image::ImageU32& ids,
                               const TruthImage& truth, const image::ImageRgba8& shaded);

} // namespace cdr::measure
