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

/// Those of shaders whose colours a later step finishes.
std::array<std::uint32_t, 2> finishLaterConstants();

/// A linear colour as those shaders finish it.
glm::vec3 finished(glm::vec3 color, const Finish& finish, Daylight daylight);

/// What an 8-bit sRGB picture has where no surface is: the background as finished(), moved to the middle of the nearest step.
/// Devices may round a colour that is cleared to otherwise than one that a shader writes. From there both give this step.
glm::vec3 shownBackground(const glm::vec3& background, const Finish& finish, Daylight daylight);

} // namespace cdr::render
