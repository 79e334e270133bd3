#pragma once

#include <cdr/base/export.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/render_options.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <span>

namespace cdr::render {

/// Drops the triangles of meshes and the pixels of textures that the cascades of options.part do not draw. This
/// holds as long as these cameras are used one after the other from the first frame on. All instances stay,
/// with their bounding spheres, so every part cuts the view alike.
/// @throws base::InputError for an unusable camera or split; then the scene is as it was.
CDR_EXPORT void dropOtherParts(scene::Scene& scene, const RenderOptions& options,
                               std::span<const scene::Camera> cameras, platform::WorkerPool& workers);

} // namespace cdr::render
