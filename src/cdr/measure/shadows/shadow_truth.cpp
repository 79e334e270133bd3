#include <cdr/base/error.h>
#include <cdr/measure/shadows/shadow_truth.h>
#include <cdr/measure/truth/lens.h>

#include <algorithm>
#include <cmath>

namespace cdr::measure {

namespace {

/// Shares of the way: nearer than that to where a ray begins, or to the light where it ends, is the same place.
constexpr double kSamePlace = 1e-10;
/// Cosine of the angle of incidence below which a surface gets next to no light.
constexpr double kMinCosine = 1e-3;
/// Pixels between the rays that tell how a surface lies.
constexpr double kAside = 1e-4;

std::vector<std::uint32_t> solidInstances(const scene::Scene& scene) {
    std::vector<std::uint32_t> solid;
    const scene::Instances& instances = scene.instances;
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const bool isThere = instances.radius[i] >= 0.0f;
        if (isThere && scene.materials[instances.material[i]].alphaMode != scene::AlphaMode::blend) {
            solid.push_back(i);
        }
    }
    return solid;
}

/// Whether a light's cone and range let some light through. @param way from a point to the light.
bool shinesAlong(const scene::PointLight& light, const glm::dvec3& way) {
    const double distance = glm::length(way);
    return !(light.range && distance >= *light.range) &&
           !(light.cone && -glm::dot(light.cone->direction, way) <= std::cos(light.cone->outer) * distance);
}

} // namespace

ShadowTruthCaster::ShadowTruthCaster(const scene::Scene& scene, std::span<const Shape> shapes)
    : m_scene(&scene),
      m_casters(scene.instances.size()),
      m_bvh(scene.instances, solidInstances(scene)) {
    for (std::size_t i = 0; i < m_casters.size(); ++i) {
        if (const std::optional<InverseBasis> inverse = invertBasis(scene.instances.basis[i])) {
            m_casters[i] = {.shape = &shapes[scene.instances.mesh[i]],
                            .worldToObject = inverse->worldToObject,
                            .sides = sidednessOf(scene.materials[scene.instances.material[i]])};
        }
    }
}

ObjectRay ShadowTruthCaster::placed(const Ray& ray, std::uint32_t instance) const {
    const glm::dvec3 origin = (ray.camera - m_scene->instances.position(instance)) + ray.from;
    const glm::dmat3& toObject = m_casters[instance].worldToObject;
    return {toObject * origin, toObject * ray.direction};
}

ShadowTruthCaster::Hit ShadowTruthCaster::nearest(const Ray& ray, const ViewRange& range) const {
    Hit hit{.at = range.farView};
    m_bvh.visit(
        ray.camera + ray.from, ray.direction, range.nearView, range.farView, [&](std::uint32_t instance) {
            const Caster& caster = m_casters[instance];
            if (caster.shape != nullptr) {
                const double at =
                    caster.shape->nearest(placed(ray, instance), caster.sides, {range.nearView, hit.at});
                if (at < hit.at || (at == hit.at && (!hit.isHit || instance < hit.instance))) {
                    hit = {.at = at, .instance = instance, .isHit = true};
                }
            }
            return hit.at;
        });
    return hit;
}

bool ShadowTruthCaster::isBlocked(const Ray& ray, const ViewRange& range) const {
    bool isBlocked = false;
    m_bvh.visit(ray.camera + ray.from, ray.direction, range.nearView, range.farView,
                [&](std::uint32_t instance) {
                    const Caster& caster = m_casters[instance];
                    isBlocked = caster.shape != nullptr &&
                                caster.shape->nearest(placed(ray, instance), Sidedness::both, range) < kNoHit;
                    return isBlocked ? range.nearView - 1.0 : range.farView;
                });
    return isBlocked;
}

bool ShadowTruthCaster::isFree(const glm::dvec3& camera, const glm::dvec3& point,
                               const glm::dvec3& way) const {
    const double shareOfPoint = glm::length(point) / glm::length(way);
    const ViewRange between{kSamePlace * std::max(shareOfPoint, kSamePlace), 1.0 - kSamePlace};
    return !isBlocked({camera, point, way}, between);
}

bool ShadowTruthCaster::reaches(const glm::dvec3& camera, const glm::dvec3& fromCamera,
                                std::size_t light) const {
    return isFree(camera, fromCamera, (m_scene->lights.at(light).position - camera) - fromCamera);
}

glm::dvec4 ShadowTruthCaster::sharesAt(const glm::dvec3& camera, const glm::dvec3& fromCamera,
                                       const glm::dvec3& normal) const {
    glm::dvec4 shares(1.0);
    const std::size_t lights = std::min<std::size_t>(m_scene->lights.size(), 4);
    for (std::size_t light = 0; light < lights; ++light) {
        const glm::dvec3 way = (m_scene->lights[light].position - camera) - fromCamera;
        // A surface that faces away from the light gets none of it in any case.
        if (glm::dot(normal, way) > 0.0 && !reaches(camera, fromCamera, light)) {
            shares[static_cast<int>(light)] = 0.0;
        }
    }
    return shares;
}

ShadowPixel ShadowTruthCaster::pixelAt(const scene::Camera& camera, const glm::dvec2& slope,
                                       const glm::dvec2& step, const scene::PointLight& light) const {
    const auto rayAt = [&](const glm::dvec2& at) {
        return Ray{camera.position, glm::dvec3(0.0), camera.right * at.x + camera.up * at.y - camera.back};
    };
    const ViewRange range{camera.nearView, camera.farView};
    const Ray ray = rayAt(slope);
    const Hit hit = nearest(ray, range);
    if (!hit.isHit) {
        return {};
    }
    ShadowPixel pixel{.id = m_scene->instances.object[hit.instance] + 1};
    const glm::dvec3 point = ray.direction * hit.at;
    // How the surface lies, by points of the same instance beside this one.
    const Caster& caster = m_casters[hit.instance];
    const auto aside = [&](const glm::dvec2& by) {
        const Ray other = rayAt(slope + kAside * by);
        const double at = caster.shape->nearest(placed(other, hit.instance), caster.sides, range);
        return other.direction * at - point;
    };
    const glm::dvec3 normal = glm::cross(aside({step.x, 0.0}), aside({0.0, step.y}));
    const glm::dvec3 way = (light.position - camera.position) - point;
    const double towardsCamera = -glm::dot(normal, point);
    const double towardsLight = glm::dot(normal, way) * (towardsCamera < 0.0 ? -1.0 : 1.0);
    if (!(towardsLight > kMinCosine * glm::length(normal) * glm::length(way)) || !shinesAlong(light, way)) {
        pixel.reach = Reach::away;
        return pixel;
    }
    pixel.reach = isFree(camera.position, point, way) ? Reach::reached : Reach::shadowed;
    return pixel;
}

ShadowImage ShadowTruthCaster::cast(const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                                    std::size_t light, platform::WorkerPool& workers) const {
    scene::requireUsable(camera);
    if (light >= m_scene->lights.size()) {
        throw base::InputError("truth of shadows: the scene has no such light");
    }
    ShadowImage truth(width, height);
    const PixelSlopes slopes = pixelSlopes(camera, width, height);
    const double pixel = 2.0 * halfHeightSlope(camera) / height;
    workers.run(height, [&](std::size_t row, std::size_t) {
        const auto y = static_cast<std::uint32_t>(row);
        for (std::uint32_t x = 0; x < width; ++x) {
            truth.at(x, y) =
                pixelAt(camera, {slopes.x[x], slopes.y[y]}, {pixel, pixel}, m_scene->lights[light]);
        }
    });
    return truth;
}

} // namespace cdr::measure
