#pragma once

#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

namespace cdr::measure {

/// A surface at a point, in float64, of the metallic-roughness material of glTF 2.0 (appendix B), written
/// apart from the renderer's shaders. Directions are unit vectors of one space.
struct GlossyPoint {
    glm::dvec3 baseColor; ///< linear
    scene::MetallicRoughness metallicRoughness;
    glm::dvec3 normal;
    glm::dvec3 toCamera;
};

/// Share of a point light's colour that reaches the camera: pi times the reflectance, times the cosine. It is 1
/// for a white matt surface that faces the light.
glm::dvec3 pointShare(const GlossyPoint& point, const glm::dvec3& toLight);

/// The part of pointShare() that is not mirrored.
glm::dvec3 diffuseShare(const GlossyPoint& point, const glm::dvec3& toLight);

/// Share of ambient light that reaches the camera, by Karis' fit.
glm::dvec3 ambientShare(const GlossyPoint& point);

/// As the renderer has it: a point light's highlight on anything smoother is smaller than a pixel.
inline constexpr double kMinTruthRoughness = 0.08;

/// What a surface sends is cut off here.
inline constexpr double kBrightest = 16.0;

} // namespace cdr::measure
