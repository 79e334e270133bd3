#pragma once

#include <cdr/scene/scene.h>

#include <cstdint>
#include <vector>

namespace cdr::visibility {

/// The instances whose material blends (AlphaMode::blend), ascending. They are translucent surfaces, which
/// are drawn after all others.
std::vector<std::uint32_t> blendedInstances(const scene::Scene& scene);

/// Whether there are any.
bool hasBlended(const scene::Scene& scene);

} // namespace cdr::visibility
