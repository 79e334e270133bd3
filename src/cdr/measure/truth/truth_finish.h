#pragma once

#include <glm/glm.hpp>

namespace cdr::measure {

/// How light becomes a picture.
struct TruthFinish {
    double exposure = 0.0; ///< stops
    bool neutral = false;  ///< tone mapping by Khronos PBR Neutral, after exposure
};

/// A linear colour as the picture has it, in float64, written apart from the renderer's shaders.
glm::dvec3 finished(const glm::dvec3& color, const TruthFinish& finish);

} // namespace cdr::measure
