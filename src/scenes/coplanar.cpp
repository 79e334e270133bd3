#include "random.h"

#include <scenes/coplanar.h>
#include <scenes/degree.h>
#include <scenes/scene_builder.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace cdr::scenes {

namespace {

constexpr std::uint32_t kPathFrames = 96;
constexpr double kCell = 10.0;
constexpr scene::Camera kLens{.fovY = 60.0 * kDegree, .nearView = 0.1, .farView = 1e4};

glm::dmat3 turnedAboutZ(double angle) {
    return {
        {std::cos(angle), std::sin(angle), 0.0}, {-std::sin(angle), std::cos(angle), 0.0}, {0.0, 0.0, 1.0}};
}

/// A rectangle in the plane z = 0, in cells no wider than kCell. Depth of a triangle that reaches from behind the camera to
/// the horizon is rounded by far more than layers are apart.
scene::SourceMesh gridMesh(const std::string& name, const glm::dvec2& halfSides) {
    const glm::uvec2 cells(glm::ceil(2.0 * halfSides / kCell));
    scene::SourceMesh mesh{.name = name, .positions = {}, .vertices = {}, .indices = {}};
    for (std::uint32_t row = 0; row <= cells.y; ++row) {
        for (std::uint32_t column = 0; column <= cells.x; ++column) {
            const glm::dvec2 share = glm::dvec2(column, row) / glm::dvec2(cells);
            mesh.positions.emplace_back((2.0 * share - 1.0) * halfSides, 0.0);
            mesh.vertices.emplace_back();
        }
    }
    for (std::uint32_t row = 0; row < cells.y; ++row) {
        for (std::uint32_t column = 0; column < cells.x; ++column) {
            const std::uint32_t a = row * (cells.x + 1) + column;
            const std::uint32_t b = a + cells.x + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    }
    return mesh;
}

/// A face of a wall, a floor or a roof: an origin, two axes within it, and where it looks, all of unit length.
struct Face {
    glm::dvec3 origin;
    glm::dmat3 axes; ///< across, along, out
};

Face groundAt(const glm::dvec3& origin) {
    return {origin, {{1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}}};
}

/// Puts flat objects on faces, each with a layer offset.
class Yard {
  public:
    explicit Yard(scene::Scene& scene) : m_builder(scene) {}

    SceneBuilder& builder() { return m_builder; }

    std::uint32_t material(const std::string& name, const glm::vec3& color, int layer = 0) {
        const float offset = static_cast<float>(layer) * kCoplanarLayer;
        return m_builder.addMaterial(
            {.name = name, .baseColorFactor = glm::vec4(color, 1.0f), .layer = offset});
    }

    /// A rectangle on a face.
    /// @param turn about the face's normal, radians: turned, its triangles are others than those of what it lies on.
    void add(const std::string& name, std::uint32_t material, const Face& face, const glm::dvec2& middle,
             const glm::dvec2& halfSides, double turn = 0.0) {
        m_builder.beginObject(name);
        const glm::dmat3 turned = face.axes * turnedAboutZ(turn);
        glm::dmat4 toWorld(turned);
        toWorld[3] = glm::dvec4(face.origin + face.axes * glm::dvec3(middle, 0.0), 1.0);
        m_builder.addMesh(material, gridMesh(name, halfSides), toWorld);
    }

  private:
    SceneBuilder m_builder;
};

/// A map: land, parcels on it, roads across them, markings on the roads.
void addMap(Yard& yard) {
    const Face ground = groundAt(glm::dvec3(0.0));
    const std::uint32_t land = yard.material("land", {0.35f, 0.42f, 0.25f});
    const std::uint32_t parcel = yard.material("parcel", {0.55f, 0.5f, 0.3f}, 1);
    const std::uint32_t road = yard.material("road", {0.12f, 0.12f, 0.13f}, 2);
    const std::uint32_t crossing = yard.material("crossing", {0.2f, 0.2f, 0.22f}, 3);
    const std::uint32_t marking = yard.material("marking", {0.85f, 0.85f, 0.8f}, 4);
    // The upper layers first, so that no order of drawing helps.
    for (int i = -8; i <= 8; ++i) {
        yard.add("marking", marking, ground, {6.0 * i, 12.0}, {1.2, 0.25}, 0.0);
        yard.add("marking", marking, ground, {-25.0, 7.0 * i}, {0.25, 1.6}, 0.02 * i);
    }
    yard.add("road east", road, ground, {0.0, 12.0}, {120.0, 4.0});
    yard.add("road north", road, ground, {-25.0, 0.0}, {4.0, 120.0}, 0.05);
    yard.add("crossing", crossing, ground, {-25.5, 12.0}, {6.0, 6.0}, 0.4);
    for (int i = 0; i < 12; ++i) {
        yard.add("parcel", parcel, ground, {-90.0 + 17.0 * i, -14.0 + 9.0 * (i % 5)}, {7.0, 5.0}, 0.3 * i);
    }
    yard.add("land", land, ground, {0.0, 0.0}, {150.0, 150.0});
}

/// A building whose walls carry windows, signs and posters over posters.
void addBuilding(Yard& yard) {
    const glm::dvec3 halfSides(9.0, 6.0, 5.0);
    const glm::dvec3 centre(4.0, 6.0, -2.0);
    const std::uint32_t wall = yard.material("wall", {0.7f, 0.66f, 0.6f});
    const std::uint32_t window = yard.material("window", {0.25f, 0.35f, 0.45f}, 1);
    const std::uint32_t sign = yard.material("sign", {0.75f, 0.55f, 0.15f}, 2);
    const std::uint32_t poster = yard.material("poster", {0.2f, 0.45f, 0.65f}, 3);
    const std::array walls{
        Face{centre + glm::dvec3(0.0, 0.0, halfSides.z), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        Face{centre - glm::dvec3(0.0, 0.0, halfSides.z), {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},
        Face{centre + glm::dvec3(halfSides.x, 0.0, 0.0), {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}},
        Face{centre - glm::dvec3(halfSides.x, 0.0, 0.0), {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}}};
    for (const Face& face : walls) {
        yard.add("poster", poster, face, {1.0, -2.2}, {0.9, 1.3}, 0.1);
        yard.add("sign", sign, face, {0.6, -2.0}, {1.6, 1.1}, -0.07);
        for (int i = 0; i < 6; ++i) {
            yard.add("window", window, face, {-3.2 + 3.2 * (i % 3), 0.4 + 3.0 * std::floor(i / 3)},
                     {1.0, 0.9});
        }
    }
    yard.builder().beginObject("building");
    yard.builder().addBox(wall, centre, halfSides);
}

/// Two machines whose plates share a face, and a model that was imported twice.
void addMachines(Yard& yard) {
    const std::uint32_t steel = yard.material("steel", {0.5f, 0.52f, 0.55f});
    const std::uint32_t plate = yard.material("plate", {0.3f, 0.32f, 0.5f}, 1);
    const std::uint32_t second = yard.material("second import", {0.5f, 0.3f, 0.3f}, 1);
    const std::uint32_t first = yard.material("first import", {0.3f, 0.5f, 0.3f});
    SceneBuilder& builder = yard.builder();
    builder.beginObject("plate");
    builder.addBox(plate, {-8.0, 1.5, 6.0}, {0.8, 0.6, 1.0});
    builder.beginObject("machine");
    builder.addBox(steel, {-9.0, 1.2, 6.0}, {1.8, 1.2, 1.0}); // its front and back are the plate's
    const glm::dmat3 turned(glm::dvec3(0.8, 0.0, -0.6), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.6, 0.0, 0.8));
    for (const auto& [name, material] :
         {std::pair{"second import", second}, std::pair{"first import", first}}) {
        builder.beginObject(name);
        builder.addBox(material, {-16.0, 1.0, 4.0}, {1.5, 1.0, 1.5}, turned);
    }
}

/// A thin wall, and on its back a sign in the highest layer.
void addThinWall(Yard& yard) {
    const std::uint32_t hidden = yard.material("hidden sign", {0.8f, 0.05f, 0.05f}, 5);
    const std::uint32_t panel = yard.material("panel", {0.75f, 0.75f, 0.72f});
    const glm::dvec3 centre(20.0, 2.0, 5.0);
    const Face back{centre - glm::dvec3(0.0, 0.0, 0.5 * kCoplanarWall), {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};
    yard.add("hidden sign", hidden, back, {0.0, 0.0}, {2.5, 1.4}, 0.05);
    yard.builder().beginObject("panel");
    yard.builder().addBox(panel, centre, {3.0, 2.0, 0.5 * kCoplanarWall});
}

} // namespace

scene::SceneSetup makeCoplanar() {
    scene::SceneSetup setup;
    scene::Scene& scene = setup.scene;
    scene.name = "coplanar";
    scene.ambient = glm::vec3(0.35f);
    scene.background = glm::vec3(0.35f, 0.5f, 0.7f);
    scene.lights.push_back(farLight({0.5, 0.8, 0.6}, 1e9));
    Yard yard(scene);
    addMap(yard);
    addBuilding(yard);
    addMachines(yard);
    addThinWall(yard);
    setup.path = {.frames = kPathFrames, .at = [](std::uint32_t frame) {
                      // Once around, from 30 m to 3 km and back, never below the roofs of cars.
                      const double turn = 2.0 * std::numbers::pi * (frame % kPathFrames) / kPathFrames;
                      const double distance = 30.0 * std::pow(100.0, 0.5 - 0.5 * std::cos(turn));
                      const glm::dvec3 eye(distance * std::sin(turn), 2.0 + 0.15 * distance,
                                           distance * std::cos(turn));
                      return scene::lookAt(kLens, eye, {0.0, 3.0, 0.0});
                  }};
    return setup;
}

scene::Camera coplanarView(std::uint64_t seed, std::uint32_t view) {
    Random random(seed * 1'000'003 + view);
    const double x = random.uniform(-30.0, 30.0);
    const double y = random.uniform(0.0, 8.0);
    const double z = random.uniform(-20.0, 20.0);
    const double distance = 2.0 * std::pow(1000.0, random.uniform(0.0, 1.0));
    const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double height = std::pow(random.uniform(0.1, 0.95), 2.0);
    const double across = std::sqrt(1.0 - height * height);
    const glm::dvec3 target(x, y, z);
    const glm::dvec3 outwards(across * std::sin(turn), height, across * std::cos(turn));
    return scene::lookAt(kLens, target + distance * outwards, target);
}

} // namespace cdr::scenes
