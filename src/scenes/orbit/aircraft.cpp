#include <scenes/orbit/airport.h>
#include <scenes/solids.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace cdr::scenes {

namespace {

/// A wing or fin: two rims of leading and trailing edge, with a thickness at the root that halves to the tip.
scene::SourceMesh wing(std::string name, const std::array<glm::dvec3, 4>& outline,
                       const glm::dvec3& thickness) {
    // Root leading, root trailing, tip trailing, tip leading; counter-clockwise seen from where it points.
    const glm::dvec3 root = 0.5 * thickness;
    const glm::dvec3 tip = 0.25 * thickness;
    return hexahedron(std::move(name),
                      {outline[0] - root, outline[1] - root, outline[2] - tip, outline[3] - tip,
                       outline[0] + root, outline[1] + root, outline[2] + tip, outline[3] + tip});
}

/// The same on the other side of the plane z = 0.
std::array<glm::dvec3, 4> mirrored(const std::array<glm::dvec3, 4>& outline) {
    const glm::dvec3 across(1.0, 1.0, -1.0);
    return {outline[3] * across, outline[2] * across, outline[1] * across, outline[0] * across};
}

/// wing() takes rims in one turn, so the mirrored one begins at its tip.
scene::SourceMesh mirroredWing(std::string name, const std::array<glm::dvec3, 4>& outline,
                               const glm::dvec3& thickness) {
    const std::array<glm::dvec3, 4> m = mirrored(outline);
    const glm::dvec3 root = 0.5 * thickness;
    const glm::dvec3 tip = 0.25 * thickness;
    return hexahedron(std::move(name), {m[0] - tip, m[1] - tip, m[2] - root, m[3] - root, m[0] + tip,
                                        m[1] + tip, m[2] + root, m[3] + root});
}

} // namespace

void addAircraft(SceneBuilder& builder) {
    const std::uint32_t white = builder.addMaterial("fuselage", glm::vec3(0.75f));
    const std::uint32_t grey = builder.addMaterial("wing", glm::vec3(0.45f, 0.47f, 0.5f));
    const std::uint32_t blue = builder.addMaterial("fin", glm::vec3(0.03f, 0.12f, 0.4f));
    const std::uint32_t dark = builder.addMaterial("tyres", glm::vec3(0.03f));
    builder.beginObject("aircraft");
    // Nose to +x, y up, z to its right wing, the origin on the ground below the wings' middle.
    glm::dmat4 place = glm::translate(glm::dmat4(1.0), kApronParking + glm::dvec3(0.0, kSlabHeight, 0.0));
    place = glm::rotate(place, -0.5, glm::dvec3(0.0, 1.0, 0.0));
    const auto add = [&](std::uint32_t material, const scene::SourceMesh& mesh, const glm::dvec3& at) {
        builder.addMesh(material, mesh, glm::translate(place, at));
    };
    constexpr double kAxis = 3.6; // height of the fuselage's middle
    constexpr std::array<glm::dvec2, 11> kFuselage{{{-19.5, 0.0},
                                                    {-19.3, 0.25},
                                                    {-15.0, 1.0},
                                                    {-10.0, 1.75},
                                                    {-7.0, 1.97},
                                                    {12.5, 1.97},
                                                    {14.5, 1.8},
                                                    {16.3, 1.4},
                                                    {17.4, 0.9},
                                                    {17.9, 0.4},
                                                    {18.0, 0.0}}};
    add(white, turnedSolid("fuselage", kFuselage, 32), {0.0, kAxis, 0.0});
    constexpr std::array<glm::dvec2, 8> kEngine{{{-2.2, 0.0},
                                                 {-2.2, 0.6},
                                                 {-0.5, 1.05},
                                                 {1.2, 1.15},
                                                 {1.9, 1.05},
                                                 {2.0, 0.9},
                                                 {1.4, 0.85},
                                                 {1.4, 0.0}}};
    for (const double side : {-1.0, 1.0}) {
        add(grey, turnedSolid("engine", kEngine, 24), {3.0, 1.75, side * 5.75});
    }
    constexpr std::array<glm::dvec3, 4> kWing{
        {{4.2, 2.9, 1.0}, {-2.6, 2.9, 1.0}, {-4.2, 4.2, 17.5}, {-2.6, 4.2, 17.5}}};
    constexpr std::array<glm::dvec3, 4> kTailplane{
        {{-14.2, 4.3, 0.4}, {-17.6, 4.3, 0.4}, {-18.6, 4.8, 6.2}, {-17.2, 4.8, 6.2}}};
    for (const auto& [outline, thickness] : {std::pair(kWing, 0.7), std::pair(kTailplane, 0.3)}) {
        const glm::dvec3 up(0.0, thickness, 0.0);
        add(grey, mirroredWing("left wing", outline, up), {});
        add(grey, wing("right wing", outline, up), {});
    }
    constexpr std::array<glm::dvec3, 4> kFin{
        {{-12.8, 5.2, 0.0}, {-18.0, 5.2, 0.0}, {-19.4, 11.7, 0.0}, {-17.6, 11.7, 0.0}}};
    add(blue, wing("fin", kFin, {0.0, 0.0, -0.4}), {});
    for (const glm::dvec3& wheel :
         {glm::dvec3(12.6, 0.4, 0.0), glm::dvec3(-0.6, 0.6, 3.8), glm::dvec3(-0.6, 0.6, -3.8)}) {
        const std::array<glm::dvec3, 8> box{{{-0.6, -wheel.y, 0.3},
                                             {0.6, -wheel.y, 0.3},
                                             {0.6, -wheel.y, -0.3},
                                             {-0.6, -wheel.y, -0.3},
                                             {-0.5, 1.6, 0.2},
                                             {0.5, 1.6, 0.2},
                                             {0.5, 1.6, -0.2},
                                             {-0.5, 1.6, -0.2}}};
        add(dark, hexahedron("landing gear", box), wheel);
    }
}

void addParkedModel(SceneBuilder& builder, const scene::Scene& model) {
    scene::Scene& scene = builder.scene();
    const auto firstMesh = static_cast<std::uint32_t>(scene.meshes.size());
    const auto firstMaterial = static_cast<std::uint32_t>(scene.materials.size());
    const auto firstTexture = static_cast<std::uint32_t>(scene.textures.size());
    const auto firstObject = static_cast<std::uint32_t>(scene.objectNames.size());
    scene.meshes.insert(scene.meshes.end(), model.meshes.begin(), model.meshes.end());
    scene.textures.insert(scene.textures.end(), model.textures.begin(), model.textures.end());
    for (scene::Material material : model.materials) {
        scene::forEachTexture(material, [&](std::uint32_t& texture) { texture += firstTexture; });
        scene.materials.push_back(std::move(material));
    }
    double lowest = std::numeric_limits<double>::infinity();
    const scene::Instances& from = model.instances;
    for (std::size_t i = 0; i < from.size(); ++i) {
        for (const scene::Vertex& vertex : model.meshes[from.mesh[i]].vertices) {
            const glm::dvec3 corner = glm::dmat3(from.basis[i]) * glm::dvec3(vertex.position);
            lowest = std::min(lowest, from.y[i] + corner.y);
        }
    }
    const glm::dvec3 ground = kApronParking + glm::dvec3(0.0, kSlabHeight - lowest, 0.0);
    for (std::size_t i = 0; i < from.size(); ++i) {
        scene::addInstance(scene, firstMesh + from.mesh[i], firstMaterial + from.material[i],
                           firstObject + from.object[i], from.position(i) + ground, from.basis[i]);
    }
    for (std::uint32_t object = 0; object < model.objectCount(); ++object) {
        const bool named = object < model.objectNames.size();
        builder.beginObject("model " + (named ? model.objectNames[object] : std::to_string(object)));
    }
}

} // namespace cdr::scenes
