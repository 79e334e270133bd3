#pragma once

#include <cdr/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::visibility {

/// The instances whose material blends (AlphaMode::blend), ascending. They are translucent surfaces, which
/// are drawn after all others.
std::vector<std::uint32_t> blendedInstances(const scene::Scene& scene);

/// Whether an instance is one of them. A place without an instance is not.
bool isBlended(const scene::Scene& scene, std::size_t instance);

/// Whether there are any.
bool hasBlended(const scene::Scene& scene);

} // namespace cdr::visibility
