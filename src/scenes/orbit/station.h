#pragma once

#include <scenes/scene_builder.h>

#include <glm/glm.hpp>

namespace cdr::scenes {

/// A station's window, where it is and where it faces.
struct StationPose {
    glm::dvec3 eye{0.0};     ///< world space; the middle of the window is kWindowDistance before it
    glm::dvec3 forward{0.0}; ///< world space, unit, level
    glm::dvec3 up{0.0};      ///< world space, unit, away from the Earth
};

inline constexpr double kWindowDistance = 0.25; ///< metres; the frame's edges are 0.3 from the eye
inline constexpr double kWindowTilt = 50.0;     ///< degrees below level that the window faces

/// The window frame with its bolts, and outside a handrail, a truss and panels from 1 to 40 m away. None of
/// it stands between the eye and what lies steeper than 70 degrees below level.
void addStation(SceneBuilder& builder, const StationPose& pose);

} // namespace cdr::scenes
