#pragma once

#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::experiments {

/// `count` views of a still scene. The first is the camera's own. The others look from evenly spread directions, as far from
/// the middle of all instances as the camera is.
/// @param up of the others, world space; none for that of scene::lookAt().
/// @throws base::InputError where a view lies along `up`.
std::vector<scene::Camera> viewsAround(const scene::Scene& scene, const scene::Camera& own,
                                       std::uint32_t count, const std::optional<glm::dvec3>& up);

} // namespace cdr::experiments
