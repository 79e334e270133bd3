#pragma once

#include <cdr/scene/scene.h>

#include <cstddef>

namespace cdr::experiments {

/// How thick an instance is, in scene units: how far its vertices reach along the normal of its largest triangle. It is 0 for
/// a flat face, whichever way the face is turned in its mesh, and 0 for a mesh without triangles.
double thicknessOf(const scene::Scene& scene, std::size_t instance);

} // namespace cdr::experiments
