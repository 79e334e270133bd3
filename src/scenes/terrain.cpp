#include <cdr/base/error.h>
#include <scenes/degree.h>
#include <scenes/random.h>
#include <scenes/terrain.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace cdr::scenes {

namespace {

constexpr std::uint32_t kMaxTerrainCells = 2048;
constexpr double kTerrainHalfSide = 20'000.0;
constexpr double kTerrainCircle = 500.0;
constexpr double kTerrainEyeHeight = 120.0; ///< over the ground below

/// Waves of ever shorter length and lesser height; those that fold at their crests make ridges.
class Hills {
  public:
    explicit Hills(Random& random) {
        double length = 24'000.0;
        for (Wave& wave : m_waves) {
            const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
            wave = {.along = 2.0 * std::numbers::pi / length * glm::dvec2(std::cos(turn), std::sin(turn)),
                    .phase = random.uniform(0.0, 2.0 * std::numbers::pi),
                    .height = 0.03 * length};
            length *= 0.62;
        }
    }
    double at(const glm::dvec2& place) const {
        double height = 0.0;
        for (const Wave& wave : m_waves) {
            height += wave.height * (0.6 - std::abs(std::sin(glm::dot(wave.along, place) + wave.phase)));
        }
        return height;
    }

  private:
    struct Wave {
        glm::dvec2 along{0.0};
        double phase = 0.0;
        double height = 0.0;
    };
    std::array<Wave, 12> m_waves;
};

glm::u8vec4 colourAt(double height, double up) {
    constexpr glm::u8vec4 kGrass(70, 110, 50, 255);
    constexpr glm::u8vec4 kRock(120, 110, 100, 255);
    constexpr glm::u8vec4 kSnow(235, 240, 245, 255);
    return up < 0.95 ? kRock : height > 700.0 ? kSnow : kGrass;
}

scene::Mesh meshOf(const Hills& hills, std::uint32_t cells) {
    scene::Mesh mesh;
    mesh.name = "terrain";
    const double step = 2.0 * kTerrainHalfSide / cells;
    for (std::uint32_t z = 0; z <= cells; ++z) {
        for (std::uint32_t x = 0; x <= cells; ++x) {
            const glm::dvec2 place(x * step - kTerrainHalfSide, z * step - kTerrainHalfSide);
            const auto slope = [&](const glm::dvec2& way) {
                return (hills.at(place + way) - hills.at(place - way)) / (2.0 * step);
            };
            const glm::dvec3 normal =
                glm::normalize(glm::dvec3(-slope({step, 0.0}), 1.0, -slope({0.0, step})));
            const double height = hills.at(place);
            mesh.vertices.push_back({.position = glm::vec3(place.x, height, place.y),
                                     .normal = glm::vec3(normal),
                                     .color = colourAt(height, normal.y)});
        }
    }
    for (std::uint32_t z = 0; z < cells; ++z) {
        for (std::uint32_t x = 0; x < cells; ++x) {
            const std::uint32_t corner = z * (cells + 1) + x;
            const std::uint32_t below = corner + cells + 1;
            mesh.indices.insert(mesh.indices.end(),
                                {corner, below, corner + 1, corner + 1, below, below + 1});
        }
    }
    mesh.boundingRadius = scene::boundingRadiusOf(mesh.vertices);
    return mesh;
}

} // namespace

scene::SceneSetup makeTerrain(std::uint64_t seed, std::uint32_t cells) {
    if (cells < 1 || cells > kMaxTerrainCells) {
        throw base::InputError("terrain: 1 to " + std::to_string(kMaxTerrainCells) +
                               " cells along each side, not " + std::to_string(cells));
    }
    Random random(seed);
    const Hills hills(random);
    scene::SceneSetup setup;
    scene::Scene& scene = setup.scene;
    scene.name = "terrain";
    scene.meshes.push_back(meshOf(hills, cells));
    scene.materials.push_back({.name = "ground"});
    scene.background = glm::vec3(0.45f, 0.62f, 0.85f);
    scene.ambient = glm::vec3(0.25f);
    scene.lights.push_back(
        {.position = glm::dvec3(3e5, 2e5, 1e5), .color = glm::vec3(1.0f), .halfDistance = 1e7});
    scene::addInstance(scene, 0, 0, 0, glm::dvec3(0.0), glm::mat3(1.0f));

    double eye = hills.at(glm::dvec2(0.0));
    for (int turn = 0; turn < 360; ++turn) { // over all that the circle passes
        const double angle = turn * kDegree;
        eye = std::max(eye, hills.at(kTerrainCircle * glm::dvec2(std::cos(angle), std::sin(angle))));
    }
    eye += kTerrainEyeHeight;
    setup.path = {.frames = 360, .at = [eye](std::uint32_t frame) {
                      const double angle = frame % 360 * kDegree;
                      const glm::dvec3 position(kTerrainCircle * std::cos(angle), eye,
                                                kTerrainCircle * std::sin(angle));
                      const glm::dvec3 ahead(-std::sin(angle), -0.06, std::cos(angle));
                      const scene::Camera lens{.fovY = 60.0 * kDegree, .nearView = 1.0, .farView = 60'000.0};
                      return scene::lookAt(lens, position, position + ahead);
                  }};
    return setup;
}

} // namespace cdr::scenes
