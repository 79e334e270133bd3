#include <cdr/base/error.h>
#include <scenes/city.h>
#include <scenes/cube_scene.h>
#include <scenes/degree.h>
#include <scenes/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace cdr::scenes {

namespace {

constexpr double kBlock = 100.0;
constexpr double kLot = 20.0; ///< 4 x 4 of them in a block; what is left is street
constexpr double kStreet = kBlock - 4.0 * kLot;
constexpr std::uint32_t kHousesPerSide = 4;
constexpr std::uint32_t kFloors = 9; ///< with windows
constexpr std::uint32_t kBoxesPerBlock = 625;
constexpr double kDriverHeight = 1.7;
constexpr std::uint32_t kFrames = 240;

enum Paint : std::uint32_t { road, glass, metal, leaf, firstCar, firstWall = firstCar + 3 };
constexpr std::uint32_t kCars = 3;
constexpr std::uint32_t kWalls = 5;

void addPaints(scene::Scene& scene) {
    constexpr std::array kColors{
        glm::vec3(0.16f, 0.16f, 0.17f), glm::vec3(0.12f, 0.2f, 0.28f),  glm::vec3(0.3f, 0.31f, 0.32f),
        glm::vec3(0.16f, 0.32f, 0.12f), glm::vec3(0.6f, 0.08f, 0.06f),  glm::vec3(0.75f, 0.75f, 0.72f),
        glm::vec3(0.08f, 0.16f, 0.4f),  glm::vec3(0.55f, 0.35f, 0.24f), glm::vec3(0.62f, 0.57f, 0.48f),
        glm::vec3(0.45f, 0.43f, 0.42f), glm::vec3(0.6f, 0.45f, 0.3f),   glm::vec3(0.7f, 0.66f, 0.6f)};
    for (const glm::vec3& color : kColors) {
        scene.materials.push_back({.name = "paint", .baseColorFactor = glm::vec4(color, 1.0f)});
    }
}

/// Adds boxes along the world's axes, each an object of its own.
class Town {
  public:
    Town(scene::Scene& scene, std::uint64_t seed) : m_scene(scene), m_random(seed) {}

    /// One block, its corner at the origin of the corner given.
    void addBlock(const glm::dvec2& corner) {
        box(road, {corner.x + 0.5 * kBlock, -0.1, corner.y + 0.5 * kBlock}, {kBlock, 0.2, kBlock});
        for (std::uint32_t house = 0; house < kHousesPerSide * kHousesPerSide; ++house) {
            const glm::uvec2 lot(house % kHousesPerSide, house / kHousesPerSide);
            addHouse(corner + 0.5 * kStreet + kLot * (glm::dvec2(lot) + 0.5));
        }
        addStreet(corner);
    }

  private:
    void box(std::uint32_t material, const glm::dvec3& centre, const glm::dvec3& size) {
        addBox(m_scene, material, centre, glm::mat3(glm::dmat3(size.x, 0, 0, 0, size.y, 0, 0, 0, size.z)));
    }

    /// A body, a roof, and a row of windows for each side and floor: 38 boxes.
    void addHouse(const glm::dvec2& middle) {
        const std::uint32_t wall = firstWall + static_cast<std::uint32_t>(m_random.uniform(0.0, kWalls));
        const double side = m_random.uniform(17.0, kLot - 0.5);
        const double height = m_random.uniform(15.0, 60.0);
        box(wall, {middle.x, 0.5 * height, middle.y}, {side, height, side});
        box(metal, {middle.x, height + 0.3, middle.y}, {side + 0.4, 0.6, side + 0.4});
        const double storey = height / kFloors;
        for (std::uint32_t floor = 0; floor < kFloors; ++floor) {
            const double y = (floor + 0.55) * storey;
            const double wide = 0.8 * side;
            const double out = 0.5 * side + 0.05;
            box(glass, {middle.x - out, y, middle.y}, {0.1, 0.45 * storey, wide});
            box(glass, {middle.x + out, y, middle.y}, {0.1, 0.45 * storey, wide});
            box(glass, {middle.x, y, middle.y - out}, {wide, 0.45 * storey, 0.1});
            box(glass, {middle.x, y, middle.y + out}, {wide, 0.45 * storey, 0.1});
        }
    }

    /// Cars, lamps and trees along two sides: the 16 boxes that are left.
    void addStreet(const glm::dvec2& corner) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const double along = 0.5 * kStreet + kLot * (i + m_random.uniform(0.2, 0.8));
            const bool isAcross = i % 2 == 1;
            const auto at = [&](double offset) {
                return isAcross ? glm::dvec2(corner.x + along, corner.y + offset)
                                : glm::dvec2(corner.x + offset, corner.y + along);
            };
            const glm::dvec2 car = at(6.0);
            const glm::dvec3 length = isAcross ? glm::dvec3(4.4, 0.9, 1.8) : glm::dvec3(1.8, 0.9, 4.4);
            const std::uint32_t paint = firstCar + static_cast<std::uint32_t>(m_random.uniform(0.0, kCars));
            box(paint, {car.x, 0.8, car.y}, length);
            box(glass, {car.x, 1.5, car.y}, 0.6 * length);
            const glm::dvec2 tree = at(8.5);
            box(metal, {tree.x, 1.5, tree.y}, {0.3, 3.0, 0.3});
            box(leaf, {tree.x, 4.5, tree.y}, {2.6, 3.4, 2.6});
        }
    }

    scene::Scene& m_scene;
    Random m_random;
};

/// Along a street that runs to -z, round a corner, and along one that runs to +x.
scene::Camera cameraAt(std::uint32_t frame) {
    constexpr double kStraight = 80.0; // frames
    constexpr double kTurn = 60.0;
    constexpr double kPace = 0.5; // units a frame
    constexpr double kRadius = kTurn * kPace / (90.0 * kDegree);
    const double at = frame % kFrames;
    const double turned = std::clamp((at - kStraight) / kTurn, 0.0, 1.0) * 90.0 * kDegree;
    const double before = std::min(at, kStraight) * kPace;
    const double after = std::max(at - kStraight - kTurn, 0.0) * kPace;
    const glm::dvec3 eye(kRadius * (1.0 - std::cos(turned)) + after, kDriverHeight,
                         kRadius * (1.0 - std::sin(turned)) + kStraight * kPace - before);
    const glm::dvec3 ahead(std::sin(turned), 0.04, -std::cos(turned));
    return scene::lookAt({.fovY = 60.0 * kDegree, .nearView = 0.2, .farView = 8000.0}, eye, eye + ahead);
}

} // namespace

scene::SceneSetup makeCity(std::uint64_t seed, std::uint32_t blocks) {
    if (blocks % 2 != 0 || std::uint64_t{blocks} * blocks * kBoxesPerBlock > scene::kMaxObjects) {
        throw base::InputError("city: an even number of blocks a side, and at most " +
                               std::to_string(scene::kMaxObjects) + " boxes");
    }
    scene::SceneSetup setup;
    scene::Scene& scene = setup.scene;
    scene.name = "city";
    scene.meshes = {scene::makeBox(glm::vec3(0.5f))};
    scene.ambient = glm::vec3(0.4f);
    scene.background = glm::vec3(0.35f, 0.5f, 0.75f);
    scene.lights.push_back(
        {.position = glm::dvec3(6e5, 9e5, 4e5), .color = glm::vec3(0.9f), .halfDistance = 1e8});
    addPaints(scene);
    Town town(scene, seed);
    const double first = -0.5 * kBlock * blocks;
    for (std::uint32_t block = 0; block < blocks * blocks; ++block) {
        const glm::uvec2 place(block % blocks, block / blocks);
        town.addBlock(first + kBlock * glm::dvec2(place));
    }
    setup.path = {.frames = kFrames, .at = cameraAt};
    return setup;
}

} // namespace cdr::scenes
