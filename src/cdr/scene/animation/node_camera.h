#pragma once

#include <cdr/scene/camera.h>

#include <glm/glm.hpp>

#include <optional>

namespace cdr::scene {

/// A camera where a node stands, through the same lens. A node's scale and mirroring do not reach its camera. Nothing where
/// the node's axes span no space.
std::optional<Camera> carriedBy(const glm::dmat4& toWorld, Camera camera);

} // namespace cdr::scene
