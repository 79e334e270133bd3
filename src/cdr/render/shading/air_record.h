#pragma once

#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>
#include <cdr/shaders/shared.h>

namespace cdr::render {

/// The air as a camera sees it. Its height above the planet is worked out in float64.
shaders::AirRecord makeAirRecord(const scene::Air& air, const scene::Camera& camera);

} // namespace cdr::render
