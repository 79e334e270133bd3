#include <cdr/base/error.h>
#include <cdr/measure/shadows/shadow_truth.h>
#include <cdr/measure/truth/visible_instances.h>

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

/// base::InputError as requireSoundInstance().
std::vector<std::uint32_t> solidInstances(const scene::Scene& scene) {
    std::vector<std::uint32_t> solid;
    const scene::Instances& instances = scene.instances;
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        requireSoundInstance(scene, i);
        const bool isThere = instances.radius[i] >= 0.0f;
        if (isThere && scene.materials[instances.material[i]].alphaMode != scene::AlphaMode::blend) {
            solid.push_back(i);
        }
    }
    return solid;
}

/// Of a pixel's ray: its parameter is the view distance.
glm::dvec3 directionAt(const scene::Camera& camera, const glm::dvec2& slope) {
    return camera.right * slope.x + camera.up * slope.y - camera.back;
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
      m_textures(std::make_unique<const TruthTextures>(scene)),
      m_casters(scene.instances.size()),
      m_bvh(scene.instances, solidInstances(scene)) {
    for (std::size_t i = 0; i < m_casters.size(); ++i) {
        if (const std::optional<InverseBasis> inverse = invertBasis(scene.instances.basis[i])) {
            const scene::Material& material = scene.materials[scene.instances.material[i]];
            m_casters[i] = {.shape = &shapes[scene.instances.mesh[i]],
                            .worldToObject = inverse->worldToObject,
                            .sides = sidednessOf(material),
                            .isMasked = material.alphaMode == scene::AlphaMode::mask,
                            .layer = material.layer};
            m_nearestLayer = std::max(m_nearestLayer, m_casters[i].layer);
        }
    }
}

ObjectRay ShadowTruthCaster::placed(const Ray& ray, std::uint32_t instance) const {
    const glm::dvec3 origin = (ray.camera - m_scene->instances.position(instance)) + ray.from;
    const glm::dmat3& toObject = m_casters[instance].worldToObject;
    return {toObject * origin, toObject * ray.direction};
}

MaskedHit ShadowTruthCaster::nearestOf(std::uint32_t instance, const scene::Camera& camera,
                                       const PixelRay& pixel, const ViewRange& range) const {
    const Caster& caster = m_casters[instance];
    if (caster.shape == nullptr) {
        return {};
    }
    if (!caster.isMasked) {
        const ObjectRay ray = placed(
            {camera.position, glm::dvec3(0.0), directionAt(camera, {pixel.slopeX, pixel.slopeY})}, instance);
        return {.distanceView = caster.shape->nearest(ray, caster.sides, range)};
    }
    const VisibleInstance visible{
        .shape = caster.shape,
        .instance = instance,
        .sides = caster.sides,
        .camera = placeCamera(camera, m_scene->instances, instance, caster.worldToObject)};
    return nearestKept(*m_scene, *m_textures, visible, pixel, range);
}

ShadowTruthCaster::Hit ShadowTruthCaster::nearest(const scene::Camera& camera, const PixelRay& pixel,
                                                  const ViewRange& range) const {
    Hit hit;
    m_bvh.visit(camera.position, directionAt(camera, {pixel.slopeX, pixel.slopeY}), range.nearView,
                range.farView, [&](std::uint32_t instance) {
                    const double layer = m_casters[instance].layer;
                    const ViewRange open{range.nearView, std::min(range.farView, hit.lastAt(layer))};
                    const MaskedHit met = nearestOf(instance, camera, pixel, open);
                    hit.doubtRank = std::min(hit.doubtRank, met.doubtView - layer);
                    const double rank = met.distanceView - layer;
                    if (rank < hit.rank || (rank == hit.rank && instance > hit.instance)) {
                        hit = {.at = met.distanceView,
                               .rank = rank,
                               .instance = instance,
                               .doubtRank = hit.doubtRank};
                    }
                    return std::min(range.farView, hit.lastAt(m_nearestLayer));
                });
    return hit;
}

MaskedHit ShadowTruthCaster::nearestOnWay(std::uint32_t instance, const Ray& ray,
                                          const ViewRange& range) const {
    const Caster& caster = m_casters[instance];
    if (caster.shape == nullptr) {
        return {};
    }
    const ObjectRay inObject = placed(ray, instance);
    if (!caster.isMasked) {
        return {.distanceView = caster.shape->nearest(inObject, Sidedness::both, range)};
    }
    const glm::dvec3 axis =
        std::abs(ray.direction.y) < std::abs(ray.direction.x) ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = ray.halfWidth * glm::normalize(glm::cross(ray.direction, axis));
    const glm::dvec3 up = glm::cross(glm::normalize(ray.direction), right);
    return nearestKept(*m_scene, *m_textures, {instance, *caster.shape, Sidedness::both},
                       {inObject, caster.worldToObject * right, caster.worldToObject * up}, range);
}

ShadowTruthCaster::Way ShadowTruthCaster::wayOf(const Ray& ray, const ViewRange& range) const {
    Way way;
    m_bvh.visit(ray.camera + ray.from, ray.direction, range.nearView, range.farView,
                [&](std::uint32_t instance) {
                    const MaskedHit met = nearestOnWay(instance, ray, range);
                    const bool isHit = met.distanceView < kNoHit;
                    const bool isDoubtful = met.doubtView < kNoHit;
                    way.isBlocked = way.isBlocked || isHit;
                    if (isHit && !isDoubtful) { // whatever the doubts before
                        way.isDoubtful = false;
                        return range.nearView - 1.0;
                    }
                    way.isDoubtful = way.isDoubtful || isDoubtful;
                    return range.farView;
                });
    return way;
}

ShadowTruthCaster::Way ShadowTruthCaster::wayTo(const glm::dvec3& camera, const glm::dvec3& point,
                                                const glm::dvec3& way, double halfWidth) const {
    const double shareOfPoint = glm::length(point) / glm::length(way);
    const ViewRange between{kSamePlace * std::max(shareOfPoint, kSamePlace), 1.0 - kSamePlace};
    return wayOf({camera, point, way, halfWidth}, between);
}

bool ShadowTruthCaster::reaches(const glm::dvec3& camera, const glm::dvec3& fromCamera,
                                std::size_t light) const {
    const glm::dvec3 way = (m_scene->lights.at(light).position - camera) - fromCamera;
    return !wayTo(camera, fromCamera, way, 0.0).isBlocked;
}

glm::dvec4 ShadowTruthCaster::sharesAt(const glm::dvec3& camera, const glm::dvec3& fromCamera,
                                       const glm::dvec3& normal) const {
    glm::dvec4 shares(1.0);
    const std::vector<std::uint32_t> lights = scene::shadowLights(m_scene->lights);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const glm::dvec3 way = (m_scene->lights[lights[i]].position - camera) - fromCamera;
        // A surface that faces away from the light gets none of it in any case.
        if (glm::dot(normal, way) > 0.0 && !reaches(camera, fromCamera, lights[i])) {
            shares[static_cast<int>(i)] = 0.0;
        }
    }
    return shares;
}

ShadowPixel ShadowTruthCaster::pixelAt(const scene::Camera& camera, const PixelRay& pixel,
                                       const scene::PointLight& light) const {
    const ViewRange range{camera.nearView, camera.farView};
    const Hit hit = nearest(camera, pixel, range);
    if (hit.rank == kNoHit) {
        return {.isDoubtful = hit.doubtRank < kNoHit};
    }
    ShadowPixel found{.id = m_scene->instances.object[hit.instance] + 1,
                      .isDoubtful = hit.doubtRank <= hit.rank};
    const glm::dvec3 point = directionAt(camera, {pixel.slopeX, pixel.slopeY}) * hit.at;
    // How the surface lies, by points of the same instance beside this one.
    const auto aside = [&](double x, double y) {
        const PixelRay other{pixel.slopeX + kAside * x, pixel.slopeY + kAside * y, pixel.step};
        const double at = nearestOf(hit.instance, camera, other, range).distanceView;
        return directionAt(camera, {other.slopeX, other.slopeY}) * at - point;
    };
    const glm::dvec3 normal = glm::cross(aside(pixel.step, 0.0), aside(0.0, pixel.step));
    const glm::dvec3 way = (light.position - camera.position) - point;
    const double towardsCamera = -glm::dot(normal, point);
    const double towardsLight = glm::dot(normal, way) * (towardsCamera < 0.0 ? -1.0 : 1.0);
    if (!(towardsLight > kMinCosine * glm::length(normal) * glm::length(way)) || !shinesAlong(light, way)) {
        found.reach = Reach::away;
        return found;
    }
    const Way lit = wayTo(camera.position, point, way, 0.5 * pixel.step * hit.at);
    found.reach = lit.isBlocked ? Reach::shadowed : Reach::reached;
    found.isDoubtful = found.isDoubtful || lit.isDoubtful;
    return found;
}

ShadowImage ShadowTruthCaster::cast(const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                                    std::size_t light, platform::WorkerPool& workers) const {
    scene::requireUsable(camera);
    if (light >= m_scene->lights.size()) {
        throw base::InputError("truth of shadows: the scene has no such light");
    }
    ShadowImage truth(width, height);
    const PixelSlopes slopes = pixelSlopes(camera, width, height);
    workers.run(height, [&](std::size_t row, std::size_t) {
        const auto y = static_cast<std::uint32_t>(row);
        for (std::uint32_t x = 0; x < width; ++x) {
            truth.at(x, y) = pixelAt(camera, {slopes.x[x], slopes.y[y], slopes.step}, m_scene->lights[light]);
        }
    });
    return truth;
}

} // namespace cdr::measure
