#include "lights.h"

#include "checks.h"
#include "json.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <optional>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

/// Of the scene's radius: where a point light is half as strong as the square of the distance would have it.
constexpr double kCore = 1e-3;
/// Radii to a directional light, and from there to where it would be half as strong.
constexpr double kFarAway = 1e6;
constexpr double kFadesAfter = 1e3;
/// Each costs time at every pixel.
constexpr std::size_t kMostLights = 256;

double intensityOf(const json& light, const std::string& where) {
    const json* value = member(light, "intensity");
    if (value == nullptr) {
        return 1.0;
    }
    const double intensity = value->is_number() ? value->get<double>() : -1.0;
    if (!(intensity >= 0.0 && std::isfinite(intensity))) {
        refuse("{}: its intensity is {}", where, oneLine(value->dump()));
    }
    return intensity;
}

glm::vec3 colorOf(const json& light, const std::string& where) {
    glm::vec3 color(1.0f);
    if (const auto numbers = numbersMember(light, "color", 3, where)) {
        for (int i = 0; i < 3; ++i) {
            color[i] = static_cast<float>((*numbers)[static_cast<std::size_t>(i)]);
            if (!(color[i] >= 0.0f && std::isfinite(color[i]))) {
                refuse("{}: its colour must be 0 or more", where);
            }
        }
    }
    return color;
}

} // namespace

std::vector<GltfLight> placeLights(std::span<const LightNode> nodes, const json& root, Notes& notes) {
    const json* extension = extensionOf(root, kLights);
    std::vector<GltfLight> lights;
    for (const LightNode& node : nodes) {
        const std::string where = fmt::format("light {}", node.light);
        if (extension == nullptr) {
            refuse("{}: the file has no {}", where, kLights);
        }
        if (lights.size() == kMostLights) {
            notes.add(fmt::format("lights beyond the first {} are not used", kMostLights), where);
            continue;
        }
        const json& light = itemAt(*extension, "lights", node.light, "light");
        const std::string type = stringMember(light, "type").value_or("");
        if (type == "spot") {
            notes.add("spot lights are not used", where);
            continue;
        }
        if (type != "point" && type != "directional") {
            refuse("{}: type '{}' does not exist", where, oneLine(type, kMaxNameLength));
        }
        if (member(light, "range") != nullptr) {
            notes.add("the range of a light is not used", where);
        }
        const glm::dvec3 along = -glm::dvec3(node.toWorld[2]);
        const double length = glm::length(along);
        if (type == "directional" && !(length > 0.0 && std::isfinite(length))) {
            notes.add("a light is not used, its transform flattens it", fmt::format("node {}", node.node));
            continue;
        }
        lights.push_back({.name = oneLine(fullNameOf(light)),
                          .position = glm::dvec3(node.toWorld[3]),
                          .direction = type == "directional" ? std::optional(along / length) : std::nullopt,
                          .color = colorOf(light, where),
                          .intensity = intensityOf(light, where)});
    }
    return lights;
}

PointLight pointLightOf(const GltfLight& light, const glm::dvec3& centre, double radius) {
    // Lambert's law has a 1 / pi that cdr's lights have in their colour.
    const double strength = light.intensity / std::numbers::pi;
    PointLight made;
    if (light.direction) {
        const double distance = kFarAway * radius;
        made = {.position = centre - *light.direction * distance,
                .color = light.color * static_cast<float>(strength),
                .halfDistance = kFadesAfter * distance};
    } else {
        const double core = kCore * radius;
        made = {.position = light.position,
                .color = light.color * static_cast<float>(strength / (core * core)),
                .halfDistance = core};
    }
    if (!std::isfinite(made.color.r + made.color.g + made.color.b)) {
        throw base::InputError(
            fmt::format("light '{}' is too strong for a scene of radius {}", light.name, radius));
    }
    return made;
}

} // namespace cdr::scene::gltf
