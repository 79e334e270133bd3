#pragma once

#include <cstdint>

namespace cdr::render {

/// How layers (scene::Material::layer) become depth.
enum class LayerMethod : std::uint8_t {
    sceneUnits,    ///< by their offset
    polygonOffset, ///< by Vulkan's depth bias, times the rank of the layer: today's practice, for comparison
};

/// How surfaces in layers are drawn.
struct LayerOptions {
    LayerMethod method = LayerMethod::sceneUnits; ///< how layers become depth
    float slopeFactor = 0.0f;    ///< of polygonOffset, towards the camera, finite: depthBiasSlopeFactor
    float constantFactor = 0.0f; ///< of polygonOffset, towards the camera, finite: depthBiasConstantFactor

    /// Whether both draw alike.
    bool operator==(const LayerOptions&) const = default;
};

} // namespace cdr::render
