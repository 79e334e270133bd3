#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/scene/air.h>
#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// Meshes, materials, instances, lights, cameras, and worlds that change.
/// @threads Functions keep nothing: many threads may call them at once on what no other one changes.
namespace cdr::scene {

/// What the renderer draws, one entry per (object, primitive). A structure of arrays, since culling and
/// binning read only the first four. Positions are in world space, float64, at the centres of the bounding
/// spheres.
struct Instances {
    std::vector<double> x;           ///< world space
    std::vector<double> y;           ///< world space
    std::vector<double> z;           ///< world space
    std::vector<float> radius;       ///< world space, bounds the transformed mesh
    std::vector<glm::mat3> basis;    ///< object to world, rotation and scale; exactly these float32 values
    std::vector<std::uint32_t> mesh; ///< index into Scene::meshes
    std::vector<std::uint32_t> material; ///< index into Scene::materials
    /// Object index, shared by the primitives of one object. The id buffer holds it plus one; 0 is
    /// background.
    std::vector<std::uint32_t> object;

    /// How many there are, free places of a world included.
    std::size_t size() const { return x.size(); }
    /// World space, of one instance.
    glm::dvec3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// The cone of a spot light. Within the inner angle the light is whole. From there to the outer one it falls as the square
/// of a linear function of the angle's cosine, as KHR_lights_punctual has it.
struct LightCone {
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< that the light shines in: world axes, unit length
    double inner = 0.0;                   ///< radians from the axis, from 0 to below `outer`
    double outer = 0.7853981633974483;    ///< radians from the axis, at most half pi; beyond is no light
};

/// A light at a point. It shines alike in all directions, or within a cone.
struct PointLight {
    /// World space. Surfaces that are more than 10^18 units from a light are lit by it too brightly, or not at all.
    glm::dvec3 position{0.0};
    glm::vec3 color{1.0f}; ///< linear, 0 or more
    /// Distance at which the light is half as strong, in scene units. It falls as 1 / (1 + (d /
    /// halfDistance)^2).
    double halfDistance = 1.0;
    std::optional<LightCone> cone{}; ///< of a spot light; none: all directions
    /// Scene units, above 0: the light is also multiplied by 1 - (d / range)^4, and beyond is none. None: unlimited.
    std::optional<double> range{};
    /// Whether it casts shadows where a renderer draws them, and is one of shadowLights().
    bool castsShadows = true;
};

/// How many lights of a scene cast shadows.
inline constexpr std::size_t kMaxShadowLights = 4;

/// The first kMaxShadowLights lights that cast shadows, by index, ascending.
CDR_EXPORT std::vector<std::uint32_t> shadowLights(const std::vector<PointLight>& lights);

/// A light that shines in one direction, as the sun does: a point a million radii away from a sphere. In the sphere its
/// direction differs from `direction` by at most 1.1e-6 radians, and its light from `color` by at most a share of 1.1e-6.
/// @param direction that the light shines in: world axes, of any length above 0
/// @param color linear, on a surface that faces the light
/// @param centre of a sphere around all that is lit, in world space
/// @param radius of that sphere, in scene units, above 0; over 10^12 as PointLight::position says
/// @throws base::InputError where one of these is not finite, or has no length.
CDR_EXPORT PointLight directionalLight(const glm::dvec3& direction, const glm::vec3& color,
                                       const glm::dvec3& centre, double radius);

/// Whether a light has a cone or a range.
inline bool isShaped(const PointLight& light) {
    return light.cone.has_value() || light.range.has_value();
}

/// Light from all around, as a clear sky over a plain sends it. Below the horizon it has one colour. Above, it goes
/// from the horizon's to the zenith's in step with the sine of the elevation.
struct Sky {
    glm::vec3 zenith{0.3f, 0.42f, 0.65f};  ///< linear radiance, 0 or more
    glm::vec3 horizon{0.75f, 0.78f, 0.8f}; ///< linear radiance, 0 or more
    glm::vec3 ground{0.2f, 0.18f, 0.16f};  ///< linear radiance, 0 or more
    glm::dvec3 up{0.0, 1.0, 0.0};          ///< world space, unit length
};

/// Everything that is drawn; cameras are not part of it.
struct CDR_EXPORT Scene {
    std::string name;                     ///< for messages
    std::vector<Mesh> meshes;             ///< by Instances::mesh
    std::vector<Material> materials;      ///< by Instances::material
    std::vector<Texture> textures;        ///< by Material::baseColorTexture
    std::vector<std::string> objectNames; ///< per object; may be empty for generated scenes
    Instances instances;                  ///< what is drawn
    std::vector<PointLight> lights;       ///< beside `ambient`
    glm::vec3 ambient{0.25f};             ///< linear, multiplies albedo
    glm::vec3 background{0.0f};           ///< linear
    std::optional<Sky> sky{};             ///< takes the place of `ambient`
    std::optional<Air> air{};             ///< between the camera and what it sees

    /// One more than the largest object index; 0 of an empty scene. Looks at every instance.
    std::uint32_t objectCount() const;
};

/// Most objects in a scene: ids are written as three bytes, and 0 is the background.
inline constexpr std::uint32_t kMaxObjects = (1u << 24) - 2;

/// Appends one instance. Its radius is the mesh's times an upper bound of the basis' largest singular value.
/// @param mesh that the scene holds already
/// @param material of the scene, which is not checked, as `object` is not: requireUsable() does.
/// @param position of the mesh's origin, which is its bounding centre, in world space.
/// @throws base::InputError where the scene has no such mesh; nothing is added then.
CDR_EXPORT void addInstance(Scene& scene, std::uint32_t mesh, std::uint32_t material, std::uint32_t object,
                            const glm::dvec3& position, const glm::mat3& basis);

/// Moves an instance and gives it the radius that addInstance() would.
/// @param position as addInstance() takes it.
/// @throws base::InputError as addInstance().
CDR_EXPORT void placeInstance(Scene& scene, std::size_t instance, const glm::dvec3& position,
                              const glm::mat3& basis);

/// The radius of a place that holds no instance: no view volume is near enough to keep it. Its basis is zero.
inline constexpr float kNoRadius = std::numeric_limits<float>::lowest();

/// Exchanges two instances in the order of drawing. Their objects stay the same.
CDR_EXPORT void swapInstances(Instances& instances, std::size_t a, std::size_t b);

} // namespace cdr::scene
