#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

/// Thickness of the thinnest wall of makeCoplanar(), in scene units: more than kCoplanarLayer times its layers.
inline constexpr double kCoplanarWall = 0.05;
/// Offset of a layer of makeCoplanar(), in scene units.
inline constexpr float kCoplanarLayer = 0.002f;

/// Faces at the same place, as drawings, models of buildings and maps have them. There are markings on roads on land, signs
/// and windows on walls, and posters over posters. They are turned, and cut into other triangles than what they lie on. Two
/// machines have plates that overlap, and one model is imported twice. Each has a layer, so each place has one right
/// answer. Behind a thin wall lies a red sign that must never shine through it. Units are metres.
scene::SceneSetup makeCoplanar();

/// A random view of makeCoplanar(): from 2 to 2,000 around it, from above the ground, steep or grazing.
scene::Camera coplanarView(std::uint64_t seed, std::uint32_t view);

} // namespace cdr::scenes
