#include "lights.h"

#include "../checks.h"
#include "../json.h"

#include <cdr/base/format_error.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

/// Of the scene's radius: where a point light is half as strong as the square of the distance would have it.
constexpr double kCore = 1e-3;
/// Each costs time at every pixel.
constexpr std::size_t kMaxLights = 256;
/// Half pi, as programs round it that write few digits.
constexpr double kMaxAngle = 1.5709;

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

double intensityOf(const json& light, const std::string& where) {
    const double intensity = numberMember(light, "intensity", where).value_or(1.0);
    if (!std::isfinite(intensity)) {
        refuse("{}: its intensity is {}", where, intensity);
    }
    return intensity;
}

/// Of a spot light; its direction is that of a node without rotation.
LightCone coneOf(const json& light, const std::string& where) {
    const json& angles = objectMember(light, "spot", where);
    LightCone cone;
    cone.inner = numberMember(angles, "innerConeAngle", where).value_or(cone.inner);
    cone.outer = numberMember(angles, "outerConeAngle", where).value_or(cone.outer);
    if (!(cone.inner >= 0.0 && cone.inner <= cone.outer && cone.outer > 0.0 && cone.outer <= kMaxAngle)) {
        refuse(
            "{}: its cone is from {} to {}, and it needs 0 <= inner <= outer <= half pi, and outer above 0",
            where, cone.inner, cone.outer);
    }
    cone.outer = std::min(cone.outer, 0.5 * std::numbers::pi);
    // glTF has inner below outer, but programs write both alike for a sharp edge.
    cone.inner = std::min(cone.inner, std::nextafter(cone.outer, 0.0));
    return cone;
}

std::optional<double> rangeOf(const json& light, const std::string& where) {
    const double range = numberMember(light, "range", where).value_or(INFINITY);
    if (!(range > 0.0)) {
        refuse("{}: its range is {}", where, range);
    }
    return std::isfinite(range) ? std::optional(range) : std::nullopt;
}

/// A light of the document, at the origin.
GltfLight readLight(const json& light, const std::string& where, Notes& notes) {
    const std::string type = stringMember(light, "type").value_or("");
    if (type != "point" && type != "directional" && type != "spot") {
        refuse("{}: type '{}' does not exist", where, oneLine(type, kMaxNameLength));
    }
    GltfLight read{.name = oneLine(fullNameOf(light)),
                   .color = colorOf(light, where),
                   .intensity = intensityOf(light, where),
                   .range = rangeOf(light, where)};
    if (type == "spot") {
        read.cone = coneOf(light, where);
    }
    if (type == "directional") {
        read.direction = glm::dvec3(0.0, 0.0, -1.0);
        if (read.range) {
            notes.add("the range of a directional light means nothing", where);
            read.range.reset();
        }
    }
    return read;
}

} // namespace

std::optional<GltfLight> carriedBy(const glm::dmat4& toWorld, GltfLight light) {
    light.position = glm::dvec3(toWorld[3]);
    if (light.direction || light.cone) {
        const glm::dvec3 along = -glm::dvec3(toWorld[2]);
        const double length = glm::length(along);
        if (!(length > 0.0 && std::isfinite(length))) {
            return std::nullopt;
        }
        (light.cone ? light.cone->direction : *light.direction) = along / length;
    }
    return light;
}

LightType typeOf(const GltfLight& light) {
    return light.direction ? LightType::directional : light.cone ? LightType::spot : LightType::point;
}

std::vector<GltfLight> placeLights(std::span<const LightNode> nodes, const json& root, Notes& notes) {
    const json* extension = extensionOf(root, kLights);
    std::vector<GltfLight> lights;
    for (const LightNode& node : nodes) {
        const std::string where = fmt::format("light {}", node.light);
        if (extension == nullptr) {
            refuse("{}: the file has no {}", where, kLights);
        }
        if (lights.size() == kMaxLights) {
            notes.add(fmt::format("lights beyond the first {} are not used", kMaxLights), where);
            continue;
        }
        GltfLight read = readLight(itemAt(*extension, "lights", node.light, "light"), where, notes);
        if (read.intensity < 0.0) { // some programs have lamps that take light away
            notes.add("a light of negative intensity is not used", where);
            continue;
        }
        std::optional<GltfLight> light = carriedBy(node.toWorld, std::move(read));
        if (!light) {
            notes.add("a light is not used, because its transform is not invertible",
                      fmt::format("node {}", node.node));
            continue;
        }
        light->node = node.node;
        lights.push_back(*std::move(light));
    }
    return lights;
}

PointLight pointLightOf(const GltfLight& light, const glm::dvec3& centre, double radius) {
    // Lambert's law has a 1 / pi that cdr's lights have in their colour.
    const double strength = light.intensity / std::numbers::pi;
    const double core = kCore * radius;
    const glm::vec3 color =
        light.color * static_cast<float>(light.direction ? strength : strength / (core * core));
    if (!std::isfinite(color.r + color.g + color.b)) {
        throw base::inputError("light '{}' is too strong for a scene of radius {}", light.name, radius);
    }
    if (light.direction) {
        return directionalLight(*light.direction, color, centre, radius);
    }
    return {.position = light.position,
            .color = color,
            .halfDistance = core,
            .cone = light.cone,
            .range = light.range};
}

} // namespace cdr::scene::gltf
