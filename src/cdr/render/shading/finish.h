#pragma once

#include <cdr/render/effects.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace cdr::render {

/// Whether a scene has a sky or air.
enum class Daylight : std::uint8_t { absent, present };

inline Daylight daylightIf(bool isPresent) {
    return isPresent ? Daylight::present : Daylight::absent;
}

/// The two specialisation constants of shaders that finish colours (shading/finish.glsl).
std::array<std::uint32_t, 2> finishConstants(const Finish& finish, Daylight daylight);

/// A linear colour as those shaders finish it.
glm::vec3 finished(glm::vec3 color, const Finish& finish, Daylight daylight);

} // namespace cdr::render
