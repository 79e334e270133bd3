#pragma once

#include "../notes.h"
#include "nodes.h"

#include <cdr/scene/gltf/gltf.h>
#include <cdr/scene/scene.h>
#include <cdr/scene/scene_setup.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <vector>

namespace cdr::scene::gltf {

inline constexpr const char* kLights = "KHR_lights_punctual";

/// The lights of a scene's nodes. One of negative intensity is noted and left out. Refuses any other that is not as the
/// extension has it.
/// @param root of the document.
std::vector<GltfLight> placeLights(std::span<const LightNode> nodes, const nlohmann::json& root,
                                   Notes& notes);

/// A light where a node stands. A node's scale does not reach its light. Nothing where the light has a direction and the
/// node's transform flattens it.
std::optional<GltfLight> carriedBy(const glm::dmat4& toWorld, GltfLight light);

/// How it shines.
LightType typeOf(const GltfLight& light);

/// A light for a scene within a sphere. What falls as the square of the distance does so to 1 % from a hundredth of the
/// sphere's radius on; nearer it is weaker. One that shines in a direction is a directionalLight() of the sphere.
/// @param radius above 0. base::InputError for a light that is too strong for float32.
PointLight pointLightOf(const GltfLight& light, const glm::dvec3& centre, double radius);

} // namespace cdr::scene::gltf
