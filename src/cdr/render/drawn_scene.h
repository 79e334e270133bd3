#pragma once

#include <cdr/render/gpu_scene.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <span>

namespace cdr::render {

/// A scene as a renderer draws it.
struct DrawnScene {
    const scene::Scene& scene;
    const GpuScene& uploaded;               ///< of `scene`
    std::span<const std::uint32_t> blended; ///< instances, ascending; drawn after all others
};

} // namespace cdr::render
