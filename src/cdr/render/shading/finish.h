#pragma once

#include <cdr/render/effects.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace cdr::render {

/// The two specialisation constants of shaders that finish colours (shading/finish.glsl).
/// @param daylight whether the scene has a sky or air.
std::array<std::uint32_t, 2> finishConstants(const Finish& finish, bool daylight);

/// A linear colour as those shaders finish it.
glm::vec3 finished(glm::vec3 color, const Finish& finish, bool daylight);

} // namespace cdr::render
