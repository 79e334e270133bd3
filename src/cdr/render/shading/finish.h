#pragma once

#include <cdr/render/effects.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace cdr::render {

/// The two specialisation constants of shaders that finish colours (shading/finish.glsl).
/// @param sky whether the scene has one.
std::array<std::uint32_t, 2> finishConstants(const Finish& finish, bool sky);

/// A linear colour as those shaders finish it.
glm::vec3 finished(glm::vec3 color, const Finish& finish, bool sky);

} // namespace cdr::render
