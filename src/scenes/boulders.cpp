#include <cdr/base/error.h>
#include <cdr/scene/frustum.h>
#include <scenes/boulders.h>
#include <scenes/degree.h>
#include <scenes/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

namespace cdr::scenes {

namespace {

constexpr std::uint32_t kMaxSubdivisions = 8;
constexpr double kNearest = 8.0;
constexpr double kFarthest = 4000.0;
/// Of the camera's circle; what is nearest stays in front of it.
constexpr double kCircle = 3.0;

/// Unit directions and the triangles between them.
struct Sphere {
    std::vector<glm::dvec3> directions;
    std::vector<std::uint32_t> indices;
};

Sphere icosahedron() {
    const double t = std::numbers::phi;
    Sphere sphere{.directions = {{-1, t, 0},
                                 {1, t, 0},
                                 {-1, -t, 0},
                                 {1, -t, 0},
                                 {0, -1, t},
                                 {0, 1, t},
                                 {0, -1, -t},
                                 {0, 1, -t},
                                 {t, 0, -1},
                                 {t, 0, 1},
                                 {-t, 0, -1},
                                 {-t, 0, 1}},
                  .indices = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                              4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                              6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1}};
    for (glm::dvec3& direction : sphere.directions) {
        direction = glm::normalize(direction);
    }
    return sphere;
}

/// Every triangle becomes four.
Sphere subdivided(const Sphere& sphere) {
    Sphere finer{.directions = sphere.directions, .indices = {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [entry, isNew] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(finer.directions.size()));
        if (isNew) {
            finer.directions.push_back(glm::normalize(finer.directions[a] + finer.directions[b]));
        }
        return entry->second;
    };
    for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
        const std::array corners{sphere.indices[i], sphere.indices[i + 1], sphere.indices[i + 2]};
        const std::array edges{middle(corners[0], corners[1]), middle(corners[1], corners[2]),
                               middle(corners[2], corners[0])};
        finer.indices.insert(finer.indices.end(), edges.begin(), edges.end());
        for (std::size_t k = 0; k < 3; ++k) {
            finer.indices.insert(finer.indices.end(), {corners[k], edges[k], edges[(k + 2) % 3]});
        }
    }
    return finer;
}

/// How far out the surface lies in a direction: waves of ever shorter length and lesser height.
class Bumps {
  public:
    explicit Bumps(Random& random) {
        for (std::size_t i = 0; i < kWaves; ++i) {
            const double frequency = 2.0 * std::pow(1.35, static_cast<double>(i));
            m_waves[i] = {.direction = frequency * glm::normalize(random.inCube(1.0)),
                          .phase = random.uniform(0.0, 2.0 * std::numbers::pi),
                          .height = 0.25 / frequency};
        }
    }
    double at(const glm::dvec3& direction) const {
        double radius = 1.0;
        for (const Wave& wave : m_waves) {
            radius += wave.height * std::sin(glm::dot(wave.direction, direction) + wave.phase);
        }
        return radius;
    }

  private:
    static constexpr std::size_t kWaves = 9;
    struct Wave {
        glm::dvec3 direction;
        double phase, height;
    };
    std::array<Wave, kWaves> m_waves;
};

/// Each vertex' mean of the normals around it, weighted by area.
std::vector<glm::dvec3> smoothNormals(const std::vector<glm::dvec3>& positions,
                                      const std::vector<std::uint32_t>& indices) {
    std::vector<glm::dvec3> normals(positions.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const glm::dvec3& a = positions[indices[i]];
        const glm::dvec3 area = glm::cross(positions[indices[i + 1]] - a, positions[indices[i + 2]] - a);
        for (std::size_t k = 0; k < 3; ++k) {
            normals[indices[i + k]] += area;
        }
    }
    for (glm::dvec3& normal : normals) {
        normal = glm::normalize(normal);
    }
    return normals;
}

glm::mat3 turnedAtRandom(Random& random, double scale) {
    const glm::dvec3 axis = glm::normalize(random.inCube(1.0) + glm::dvec3(1e-9));
    const scene::Camera facing = scene::lookAt({}, axis, glm::dvec3(0.0));
    return glm::mat3(glm::dmat3(facing.right, facing.up, facing.back) * scale);
}

/// Places one boulder apart from all others; there is room, so tries end.
void placeBoulder(scene::Scene& scene, std::uint32_t object, const scene::Camera& lens, Random& random) {
    constexpr double kAspect = 16.0 / 9.0;
    const double tanY = scene::frustumOf(lens, kAspect, 1.0).tanY;
    for (;;) {
        const double w = std::exp(random.uniform(std::log(kNearest), std::log(kFarthest)));
        const double radius = 0.35 * std::sqrt(w / kNearest) * random.uniform(0.7, 1.3);
        const double up = random.uniform(-0.9, 0.9) * w * tanY;
        const double right = random.uniform(-0.9, 0.9) * w * tanY * kAspect;
        const glm::dvec3 centre(right, up, -w);
        const auto touches = [&](std::size_t i) {
            const double apart = glm::distance(centre, scene.instances.position(i));
            return apart < 1.05 * (radius + static_cast<double>(scene.instances.radius[i]));
        };
        bool isFree = true;
        for (std::size_t i = 0; i < scene.instances.size() && isFree; ++i) {
            isFree = !touches(i);
        }
        if (isFree) {
            const auto mesh = static_cast<std::uint32_t>(object % scene.meshes.size());
            const auto material = static_cast<std::uint32_t>(object % scene.materials.size());
            scene::addInstance(scene, mesh, material, object, centre, turnedAtRandom(random, radius));
            return;
        }
    }
}

} // namespace

scene::Mesh makeBoulder(std::uint64_t seed, std::uint32_t subdivisions) {
    if (subdivisions > kMaxSubdivisions) {
        throw base::InputError("a boulder has at most " + std::to_string(kMaxSubdivisions) + " subdivisions");
    }
    Sphere sphere = icosahedron();
    for (std::uint32_t i = 0; i < subdivisions; ++i) {
        sphere = subdivided(sphere);
    }
    Random random(seed);
    const Bumps bumps(random);
    double farthest = 0.0;
    for (glm::dvec3& direction : sphere.directions) {
        direction *= bumps.at(direction);
        farthest = std::max(farthest, glm::length(direction));
    }
    const std::vector<glm::dvec3> normals = smoothNormals(sphere.directions, sphere.indices);
    scene::Mesh mesh;
    mesh.name = "boulder";
    mesh.indices = std::move(sphere.indices);
    mesh.boundingRadius = 1.0f;
    for (std::size_t i = 0; i < sphere.directions.size(); ++i) {
        // A little inside, so that no rounding leaves the bound.
        const glm::vec3 position(sphere.directions[i] * (0.999999 / farthest));
        mesh.vertices.push_back({.position = position, .normal = glm::vec3(normals[i])});
    }
    return mesh;
}

scene::SceneSetup makeBoulders(std::uint64_t seed, const BoulderOptions& options) {
    constexpr std::uint32_t kMaxBoulders = 1000; // more might find no room
    constexpr std::uint32_t kMaxShapes = 64;
    if (options.boulders > kMaxBoulders || options.shapes < 1 || options.shapes > kMaxShapes) {
        throw base::InputError("boulders: at most " + std::to_string(kMaxBoulders) + ", of 1 to " +
                               std::to_string(kMaxShapes) + " shapes");
    }
    scene::SceneSetup setup;
    scene::Scene& scene = setup.scene;
    scene.name = "boulders";
    for (std::uint32_t shape = 0; shape < options.shapes; ++shape) {
        scene.meshes.push_back(makeBoulder(seed + shape, options.subdivisions));
    }
    scene.materials.push_back({.name = "sand", .baseColorFactor = glm::vec4(0.72f, 0.6f, 0.45f, 1.0f)});
    scene.materials.push_back({.name = "slate", .baseColorFactor = glm::vec4(0.4f, 0.45f, 0.52f, 1.0f)});
    scene.materials.push_back({.name = "rust", .baseColorFactor = glm::vec4(0.6f, 0.3f, 0.2f, 1.0f)});
    scene.lights.push_back(
        {.position = {4e5, 5e5, 4e5}, .color = glm::vec3(0.9f), .halfDistance = 1e7}); // shines alike on all
    scene.ambient = glm::vec3(0.12f);
    scene.background = glm::vec3(0.05f, 0.07f, 0.11f);
    const scene::Camera lens{.fovY = 60.0 * kDegree, .nearView = 0.5, .farView = 10'000.0};
    Random random(seed);
    for (std::uint32_t object = 0; object < options.boulders; ++object) {
        placeBoulder(scene, object, lens, random);
    }
    constexpr std::uint32_t kFrames = 360;
    setup.path = {.frames = kFrames, .at = [lens](std::uint32_t frame) {
                      const double angle = 2.0 * std::numbers::pi * (frame % kFrames) / kFrames;
                      scene::Camera camera = lens;
                      camera.position = kCircle * glm::dvec3(std::sin(angle), 0.0, std::cos(angle) - 1.0);
                      return camera;
                  }};
    return setup;
}

} // namespace cdr::scenes
